#include "sim/shell/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/standard_streams.h"
#include "hw/base/text.h"
#include "sim/session/options/usage.h"
#include "sim/session/options/version.h"
#include "sim/shell/manual/description.h"
#include "sim/shell/manual/help.h"
#include "sim/shell/mistakes.h"

namespace csgsim::shell {

namespace {

constexpr InputKind settings_input{"a settings file, .toml", std::size_t{1} << 20U, "a command has far fewer options"};

/// An option with the texts that CLI11 has parsed for it.
struct Tokens {
  Option* option = nullptr;
  CLI::Option* read = nullptr;
  std::string text;
  std::vector<std::string> texts;
};

/// CLI11 only splits the words; the option validates them (sim/session/options/option_list.h).
void add_to(CLI::App& app, Tokens& tokens) {
  const std::string names = fmt::format("{}", fmt::join(tokens.option->names, ","));
  if (tokens.option->takes == Takes::flag) {
    tokens.read = app.add_flag(names);
  } else if (tokens.option->takes == Takes::texts && tokens.option->is_operand) {
    tokens.read = app.add_option(names, tokens.texts);
  } else {
    // An option takes one word each time it is given, so that operands may follow it.
    tokens.read = app.add_option(names, tokens.text)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
}

/// Validates a setting that the command line overrides.
void refuse_problem(const Option& option, const Setting& setting) {
  const std::string problem = option.problem(setting.values);
  if (!problem.empty()) throw InputError(fmt::format("{}: {}: {}", setting.place, option.shown_name(), problem));
}

/// Applies the settings that the command line does not override.
void give(std::span<const Setting> settings, Command& command) {
  std::vector<std::pair<Option*, const Setting*>> to_give;
  for (const Setting& setting : settings) {
    Option& option = *command.find(setting.name);
    const bool is_overridden = option.is_given() || command.excluded_by(option) != nullptr;
    if (is_overridden) {
      refuse_problem(option, setting);
    } else {
      to_give.emplace_back(&option, &setting);
    }
  }
  for (const auto& [option, setting] : to_give) {
    if (command.excluded_by(*option) != nullptr)
      throw InputError(
          fmt::format("{}: {} excludes another option that is set; leave one out", setting->place, setting->name));
    const bool is_unset_flag = option->takes == Takes::flag && setting->values.front() == "false";
    if (is_unset_flag) continue;
    option->given = setting->values;
    option->place = setting->place;
  }
}

}  // namespace

void Command::add_quiet_option() { flag("-q,--quiet", is_quiet_, "Print nothing but errors and warnings"); }

void Command::run() const {
  if (is_quiet_) silence_prints();
  action_();
}

/// A parsed command line.
struct CommandLine::Read {
  Command* command = nullptr;
  std::string settings_file;
  bool wants_help = false;
  bool wants_dump = false;  ///< print all options as a settings file
};

CommandLine::CommandLine(std::string description, std::string program)
    : description_(std::move(description)), program_(std::move(program)) {}

Command& CommandLine::add(const std::string& name, std::string_view subject, const std::string& description,
                          const std::string& footer) {
  Command& command = commands_.emplace_back(name);
  command.subject = subject;
  command.description = description;
  command.footer = footer;
  return command;
}

Command* CommandLine::find_command(std::string_view name) {
  const auto found = std::ranges::find(commands_, name, &Command::name);
  return found == commands_.end() ? nullptr : &*found;
}

std::vector<std::string> CommandLine::command_names() const {
  std::vector<std::string> names;
  for (const Command& command : commands_) names.push_back(command.name());
  return names;
}

std::vector<SettableOption> CommandLine::options_of(std::string_view command) const {
  const auto found = std::ranges::find(commands_, command, &Command::name);
  return found->settable();
}

CommandLine::Read CommandLine::read_words(std::span<const std::string> arguments, bool takes_settings) {
  Read read{arguments.size() < 2 ? nullptr : find_command(arguments[1]), {}};
  if (read.command == nullptr) throw UsageError(unknown_command_message(arguments, command_names()));
  read.command->clear();
  const std::span<const std::string> words = arguments.subspan(2);
  if (const std::string missing = missing_value_message(*read.command, words); !missing.empty())
    throw UsageError(missing);
  CLI::App app;
  std::deque<Tokens> all;
  for (Option& option : read.command->all()) add_to(app, all.emplace_back(Tokens{&option, nullptr, {}, {}}));
  if (takes_settings && !all.empty()) {
    app.add_option(std::string(config_name), read.settings_file);
    app.add_flag(std::string(dump_name), read.wants_dump);
  }
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    read.wants_help = true;
  } catch (const CLI::ParseError& error) {
    // Replaces CLI11's message, which differs between versions of CLI11.
    const std::string message = unreadable_word_message(*read.command, words);
    throw UsageError(message.empty() ? error.what() : message);
  }
  for (const Tokens& tokens : all) tokens.option->given = tokens.read->results();
  return read;
}

std::vector<Setting> CommandLine::read_command_settings(const std::string& file, const Command& command) const {
  if (file.empty()) return {};
  std::vector<SettableCommand> known;
  for (const Command& one : commands_)
    if (!one.all().empty()) known.push_back({one.name(), one.settable()});
  return read_settings(read_file(file, settings_input), file, known, command.name());
}

void CommandLine::run_with_error_context(std::span<const std::string> arguments, const std::function<void()>& act) {
  try {
    act();
  } catch (const UsageError& error) {
    const Command* const command = arguments.size() < 2 ? nullptr : find_command(arguments[1]);
    const std::string place = command == nullptr ? "" : command->place_of(error.what());
    if (!place.empty()) throw InputError(place + ": " + error.what());
    throw UsageError(command == nullptr ? error.what() : with_help_hint(error.what(), command->name()));
  }
}

/// Prints the help of the command named by the second word, or that of the program.
void CommandLine::print_help(std::span<const std::string> words) const {
  if (words.size() < 2) return fmt::print("{}", overview_text(description_, make_command_helps(commands_)));
  const auto found = std::ranges::find(commands_, words[1], &Command::name);
  if (found == commands_.end()) throw UsageError(unknown_command_message(words, command_names()));
  fmt::print("{}", help_text(make_help(*found)));
}

/// Executes --help, --version or --describe if it is the first argument after the program's name; returns whether it
/// is.
bool CommandLine::try_program_options(std::span<const std::string> arguments) const {
  if (arguments.size() < 2) return false;
  const std::string_view first = arguments[1];
  constexpr std::string_view describing = "--describe";
  if (first == "--help" || first == "-h" || first == "help") {
    print_help(arguments.subspan(1));
  } else if (has_own_options_ && first == "--version") {
    fmt::print("{}\n", version_page());
  } else if (has_own_options_ && first == describing) {
    if (arguments.size() < 3) throw UsageError(std::string(describing), "needs a value; name a folder");
    write_description(describe(program_, description_, commands_), arguments[2]);
  } else {
    return false;
  }
  return true;
}

void CommandLine::run(std::span<char* const> arguments) {
  const std::vector<std::string> words(arguments.begin(), arguments.end());
  if (try_program_options(words)) return;
  run_with_error_context(words, [&] {
    const Read read = read_words(words, true);
    Command& command = *read.command;
    if (read.wants_help) return fmt::print("{}", help_text(make_help(command)));
    give(read_command_settings(read.settings_file, command), command);
    if (read.wants_dump) {
      command.apply_given();
      return fmt::print("{}", settings_text(command.name(), command.values()));
    }
    command.typed = words;
    command.watch = {};
    command.check_and_apply();
    command.run();
  });
}

void CommandLine::run(std::vector<std::string> words, std::span<const Setting> settings, const RunWatch& watch) {
  words.insert(words.begin(), program_);
  run_with_error_context(words, [&] {
    Command& command = *read_words(words, false).command;
    give(settings, command);
    command.watch = watch;
    command.check_and_apply();
    command.run();
  });
}

}  // namespace csgsim::shell
