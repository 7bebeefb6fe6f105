#include "sim/shell/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/standard_streams.h"
#include "hw/base/text.h"
#include "sim/shell/lists.h"
#include "sim/shell/manual/description.h"
#include "sim/shell/manual/help.h"
#include "sim/shell/options.h"
#include "sim/shell/read_by.h"
#include "sim/shell/settings/settings_app.h"
#include "sim/shell/usage.h"
#include "sim/shell/version.h"

namespace csgsim::shell {

namespace {

/// What a word of the option is called.
std::string kind_of(const CLI::Option& option) {
  std::string name = option.get_lnames().empty() ? option.get_name() : option.get_lnames().front();
  std::ranges::replace(name, '-', ' ');
  return name;
}

}  // namespace

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::check(const Check& check) {
  option_->check(check);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& names, const std::string& kind) {
  const std::string called = kind.empty() ? kind_of(*option_) : kind;
  return words(names, [names, called](const std::string& word) {
    return std::ranges::find(names, word) != names.end() ? std::string() : no_such(called, word, names);
  });
}

Option& Option::list_of(const std::vector<std::string>& names, const std::string& kind) {
  return words(names, is_read_by([names, kind](const std::string& text) { parse_names(text, kind, names); }));
}

Option& Option::words(const std::vector<std::string>& words, const Check& check) {
  option_->check(CLI::Validator([check](std::string& text) { return check(text); },
                                fmt::format("{}", fmt::join(words, ", ")), words_check));
  return *this;
}

Option& Option::folder() {
  option_->type_name(folder_type);
  return check(not_empty);
}

template <class Number>
Option& Option::between(Number low, Number high) {
  option_->check(CLI::Range(low, high).name(range_check).description(fmt::format("{} to {}", low, high)));
  return *this;
}

template Option& Option::between(int, int);
template Option& Option::between(unsigned, unsigned);

Option& Option::excludes(const std::string& other) {
  option_->excludes(other);
  return *this;
}

template <class Value>
Option Command::option(const std::string& names, Value& value, const std::string& help) {
  CLI::Option& option = *command_->add_option(names, value, help);
  constexpr bool has_default = std::is_same_v<Value, std::string> || std::is_arithmetic_v<Value>;
  return Option(has_default ? *option.capture_default_str() : option);
}

template Option Command::option(const std::string&, std::string&, const std::string&);
template Option Command::option(const std::string&, std::uint32_t&, const std::string&);
template Option Command::option(const std::string&, double&, const std::string&);
template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&);
template Option Command::option(const std::string&, std::optional<std::uint32_t>&, const std::string&);
template Option Command::option(const std::string&, std::optional<std::uint64_t>&, const std::string&);
template Option Command::option(const std::string&, std::optional<double>&, const std::string&);

Option Command::read_option(const std::string& names, const std::function<void(const std::string&)>& take,
                            const std::string& help) {
  return Option(*command_->add_option_function<std::string>(names, take, help));
}

void Command::flag(const std::string& names, bool& is_given, const std::string& help) {
  command_->add_flag(names, is_given, help);
}

void Command::prints_summary() {
  const std::string meaning = "Print nothing; errors and warnings are still told";
  command_->add_flag("-q,--quiet", meaning);
}

void Command::remove(const std::string& option) { command_->remove_option(command_->get_option(option)); }

void Command::runs(const std::function<void()>& action) {
  command_->callback([command = command_, action] {
    const CLI::Option* const quiet = command->get_option_no_throw("--quiet");
    if (quiet != nullptr && quiet->count() > 0) silence_prints();
    action();
  });
}

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

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

}  // namespace

std::vector<std::string> option_words(const std::string& name, const std::string& value) {
  if (value.starts_with('-')) return {"--" + name + "=" + value};
  return {"--" + name, value};
}

std::vector<std::string> Command::words(std::span<const std::string_view> but) const {
  std::vector<std::string> operands;
  std::vector<std::string> options;
  for (const CLI::Option* option : std::as_const(*command_).get_options()) {
    if (option->count() == 0) continue;
    if (option->get_positional()) {
      operands = joined(std::move(operands), option->results());
      continue;
    }
    if (settable(*option).name.empty()) continue;  // what a settings file says has been given
    const std::string& name = option->get_lnames().front();
    if (std::find(but.begin(), but.end(), name) != but.end()) continue;
    const bool is_flag = option->get_expected_max() == 0;
    if (is_flag && option->results().back() != "false") options.push_back("--" + name);
    for (const std::string& value : option->results())
      if (!is_flag) options = joined(std::move(options), option_words(name, value));
  }
  const auto is_like_option = [](const std::string& operand) { return operand.starts_with('-'); };
  if (std::none_of(operands.begin(), operands.end(), is_like_option))
    return joined({name()}, joined(std::move(operands), options));
  options.emplace_back("--");
  return joined({name()}, joined(std::move(options), operands));
}

namespace {

/// A question after a blank, or nothing where no known word is like it.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const std::string_view nearest = nearest_alike(word, candidates);
  return nearest.empty() ? "" : fmt::format(" did you mean {}?", nearest);
}

/// One line for people about a command line that could not be read, for the reason given; unknown commands and options
/// name the nearest known one.
std::string explain(const CLI::App& app, std::string_view reason, std::span<char* const> arguments) {
  if (arguments.size() < 2) return "a subcommand is required; see csgsim --help";
  const std::string_view first = arguments[1];
  std::vector<std::string> known;
  const CLI::App* command = nullptr;
  for (const CLI::App* one : app.get_subcommands({})) {
    if (one->get_name() == first) command = one;
    known.push_back(one->get_name());
  }
  if (command == nullptr) {
    const bool is_option = first.starts_with('-');
    if (is_option) known = {"--help", "--version"};
    return fmt::format("there is no {};{} see csgsim --help",
                       is_option ? fmt::format("option {}", first) : fmt::format("command '{}'", first),
                       did_you_mean(first, known));
  }
  known.clear();
  for (const CLI::Option* option : command->get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  const std::string help = fmt::format("see csgsim {} --help", command->get_name());
  for (const std::string_view argument : arguments.subspan(2)) {
    if (argument == "--") break;
    const std::string_view word = argument.substr(0, argument.find('='));
    const bool unknown = word.starts_with("--") && std::ranges::find(known, word) == known.end();
    if (unknown) return fmt::format("there is no option {};{} {}", word, did_you_mean(word, known), help);
  }
  return fmt::format("{}; {}", reason, help);
}

/// For the command that was asked about, or for all.
std::string help_of_app(CLI::App& app) {
  const std::vector<CLI::App*> asked = app.get_subcommands();
  if (!asked.empty()) return help_of(help_of_command(*asked.front()));
  std::vector<CommandHelp> commands;
  for (CLI::App* const command : app.get_subcommands({})) commands.push_back(help_of_command(*command));
  return help_of_all(app.get_description(), commands);
}

/// The words as main has them, which end at their first zero byte: one within a word is refused.
std::vector<char*> arguments_of(std::vector<std::string>& words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size());
  for (std::string& word : words) {
    if (word.find('\0') != word.npos)
      throw UsageError(printable(word), "it has a zero byte, which no text on a command line has; leave it out");
    arguments.push_back(word.data());
  }
  return arguments;
}

}  // namespace

CommandLine::CommandLine(const std::string& description, const std::string& program)
    : app_(make_settings_app(description, program)) {
  app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

void CommandLine::add_own_options() {
  app_->set_version_flag("--version", version_page, "Print version, commit, build and libraries");
  const auto write_pages = [app = app_.get()](const std::string& folder) {
    write_description(describe(*app), folder);
    throw CLI::Success();
  };
  app_->add_option_function<std::string>("--describe", write_pages)->group(hidden_group);
}

Command CommandLine::add(const std::string& name, const std::string& description, const std::string& footer) {
  CLI::App& command = *app_->add_subcommand(name, description);
  command.footer(footer);
  return Command(command);
}

std::vector<SettableOption> CommandLine::options_of(const std::string& command) const {
  return settable_options(*std::as_const(*app_).get_subcommand(command));
}

void CommandLine::parse(std::span<char* const> arguments, const std::function<void()>& load) {
  try {
    load();
    app_->parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", help_of_app(*app_));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError(explain(*app_, error.what(), arguments));
    app_->exit(error);
  } catch (const UsageError& error) {
    const std::string place = place_of(*app_, error.what());
    if (!place.empty()) throw InputError(place + ": " + error.what());
    throw UsageError(explain(*app_, error.what(), arguments));
  }
}

void CommandLine::run(std::span<char* const> arguments) {
  parse(arguments, [&] { load_settings(*app_, arguments); });
}

void CommandLine::run(std::vector<std::string> words, std::vector<Setting> settings) {
  words.insert(words.begin(), app_->get_name());
  const std::vector<char*> arguments = arguments_of(words);
  parse(arguments, [&] { load_settings(*app_, arguments, std::move(settings)); });
}

std::vector<std::string> CommandLine::read(std::vector<std::string> words, std::span<const std::string_view> but) {
  words.insert(words.begin(), app_->get_name());
  const std::vector<char*> arguments = arguments_of(words);
  only_read(*app_, arguments);
  try {
    app_->parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::CallForHelp&) {
    throw UsageError("it asks for help");
  } catch (const CLI::Success&) {
    return Command(*app_->get_subcommands().front()).words(but);
  } catch (const CLI::ParseError& error) {
    throw UsageError(explain(*app_, error.what(), arguments));
  }
  throw std::logic_error("a command line that was to be read alone was run");
}

}  // namespace csgsim::shell
