#include "sim/app/command_line.h"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "hw/base/error.h"
#include "sim/app/describe_app.h"
#include "sim/app/settings_app.h"
#include "sim/app/usage.h"
#include "sim/app/version.h"

namespace csgsim::app {

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::check(const Check& check) {
  option_->check(check);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& names) {
  option_->check(CLI::IsMember(names).name(words_check));
  return *this;
}

Option& Option::between(int low, int high) {
  option_->check(CLI::Range(low, high).name(range_check).description(fmt::format("{} to {}", low, high)));
  return *this;
}

Option& Option::between(unsigned low, unsigned high) {
  option_->check(CLI::Range(low, high).name(range_check).description(fmt::format("{} to {}", low, high)));
  return *this;
}

Option& Option::comma_list() {
  option_->delimiter(',');
  return *this;
}

Option& Option::excludes(const std::string& other) {
  option_->excludes(other);
  return *this;
}

namespace {

template <class Value>
Option with_default(CLI::App& command, const std::string& names, Value& value, const std::string& help) {
  return Option(*command.add_option(names, value, help)->capture_default_str());
}

template <class Value>
Option without_default(CLI::App& command, const std::string& names, Value& value, const std::string& help) {
  return Option(*command.add_option(names, value, help));
}

}  // namespace

Option Command::option(const std::string& names, std::string& value, const std::string& help) {
  return with_default(*command_, names, value, help);
}

Option Command::option(const std::string& names, std::uint32_t& value, const std::string& help) {
  return with_default(*command_, names, value, help);
}

Option Command::option(const std::string& names, double& value, const std::string& help) {
  return with_default(*command_, names, value, help);
}

Option Command::option(const std::string& names, std::vector<std::string>& values, const std::string& help) {
  return without_default(*command_, names, values, help);
}

Option Command::option(const std::string& names, std::optional<std::uint32_t>& value, const std::string& help) {
  return without_default(*command_, names, value, help);
}

Option Command::option(const std::string& names, std::optional<std::uint64_t>& value, const std::string& help) {
  return without_default(*command_, names, value, help);
}

Option Command::option(const std::string& names, std::optional<double>& value, const std::string& help) {
  return without_default(*command_, names, value, help);
}

Option Command::read_option(const std::string& names, const std::function<void(const std::string&)>& take,
                            const std::string& help) {
  return Option(*command_->add_option_function<std::string>(names, take, help));
}

void Command::flag(const std::string& names, bool& is_given, const std::string& help) {
  command_->add_flag(names, is_given, help);
}

void Command::remove(const std::string& option) { command_->remove_option(command_->get_option(option)); }

void Command::runs(const std::function<void()>& action) { command_->callback(action); }

const std::string& Command::name() const { return command_->get_name(); }

std::vector<GivenOption> Command::given() const {
  std::vector<GivenOption> given;
  for (const CLI::Option* option : std::as_const(*command_).get_options()) {
    if (option->get_positional() || option->get_lnames().empty() || option->count() == 0) continue;
    if (settable(*option).name.empty()) continue;  // what a settings file says has been given
    const std::string value = fmt::format("{}", fmt::join(option->results(), ","));
    given.push_back({option->get_lnames().front(), value, value == option->get_default_str()});
  }
  return given;
}

namespace {

std::vector<KnownCommand> known_commands(const CLI::App& app) {
  std::vector<KnownCommand> known;
  for (const CLI::App* command : app.get_subcommands({})) {
    KnownCommand& one = known.emplace_back(KnownCommand{command->get_name(), {}});
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) one.options.push_back("--" + name);
    }
  }
  return known;
}

}  // namespace

CommandLine::CommandLine(const std::string& description, const std::string& program)
    : app_(make_settings_app(description, program)) {
  app_->require_subcommand(1);
  app_->set_version_flag("--version", version_page);
  const auto write_pages = [app = app_.get()](const std::string& folder) {
    write_description(describe(*app), folder);
    throw CLI::Success();
  };
  app_->add_option_function<std::string>("--describe", write_pages)->group(hidden_group);
}

CommandLine::~CommandLine() = default;

Command CommandLine::add(const std::string& name, const std::string& description, const std::string& footer) {
  CLI::App& command = *app_->add_subcommand(name, description);
  command.footer(footer);
  return Command(command);
}

void CommandLine::run(std::span<char* const> arguments) {
  try {
    load_settings(*app_, arguments);
    app_->parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError(explain(known_commands(*app_), error.what(), arguments));
    app_->exit(error);
  } catch (const UsageError& error) {
    const std::string place = place_of(*app_, error.what());
    if (!place.empty()) throw InputError(place + ": " + error.what());
    throw UsageError(explain(known_commands(*app_), error.what(), arguments));
  }
}

}  // namespace csgsim::app
