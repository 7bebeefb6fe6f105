#pragma once

#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/session/options/option_list.h"
#include "sim/shell/settings/settings_file.h"

namespace csgsim::shell {

/// A command of a command line: a request, and what is done with it.
class Command : public OptionList {
 public:
  using OptionList::OptionList;

  /// Adds --quiet: nothing is printed, whatever the command prints.
  void prints_summary();

  /// What the command does, when the command line has been read.
  void runs(std::function<void()> action) { action_ = std::move(action); }

  void run() const;

  std::string subject;  ///< under which help has it
  std::string description;
  std::string footer;  ///< of its help: examples, and remarks

 private:
  bool is_quiet_ = false;
  std::function<void()> action_;
};

/// A command line that asks for one of several commands.
class CommandLine {
 public:
  CommandLine(std::string description, std::string program);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// The command stays where it is.
  Command& add(const std::string& name, std::string_view subject, const std::string& description,
               const std::string& footer);

  /// Adds --version, and --describe FOLDER, which writes manual pages and shells' completion there.
  void add_own_options() { has_own_options_ = true; }

  /// Every option and operand of the command that settings know.
  [[nodiscard]] std::vector<SettableOption> options_of(std::string_view command) const;

  /// Runs the command that the arguments (the first is the program's name) ask for, or prints the help they ask for.
  /// Throws UsageError with one line for people, and what the command throws.
  void run(std::span<char* const> arguments);

  /// Runs the command that the first word names, with settings that another file records; `watch` sees its run. No
  /// settings file is read. Throws as run does, and InputError with a setting's place.
  void run(std::vector<std::string> words, std::span<const Setting> settings, const RunWatch& watch = {});

 private:
  struct Read;

  [[nodiscard]] Command* command_named(std::string_view name);
  [[nodiscard]] Read read_words(std::span<const std::string> arguments, bool takes_settings);
  [[nodiscard]] bool is_answered(std::span<const std::string> arguments) const;
  [[nodiscard]] std::vector<Setting> settings_in(const std::string& file, const Command& command) const;
  [[nodiscard]] std::string explained(std::string_view reason, std::span<const std::string> arguments) const;
  void carry_out(std::span<const std::string> arguments, const std::function<void()>& act);

  std::string description_;
  std::string program_;
  bool has_own_options_ = false;
  std::deque<Command> commands_;
};

}  // namespace csgsim::shell
