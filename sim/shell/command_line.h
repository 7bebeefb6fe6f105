// Commands, their parsing and their help.
// Used by sim/shell and sim/app.
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

/// A command of the command line: a request and its action.
class Command : public OptionList {
 public:
  using OptionList::OptionList;

  /// Adds --quiet, which suppresses all text of the command on standard output.
  void add_quiet_option();

  /// Sets the action, which runs after the command line has been parsed.
  void set_action(std::function<void()> action) { action_ = std::move(action); }

  void run() const;

  std::string subject;  ///< heading of its group in help
  std::string description;
  std::string footer;  ///< end of its help: examples and remarks

 private:
  bool is_quiet_ = false;
  std::function<void()> action_;
};

/// A command line that selects one of several commands.
class CommandLine {
 public:
  CommandLine(std::string description, std::string program);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Adds a command. The reference stays valid.
  Command& add(const std::string& name, std::string_view subject, const std::string& description,
               const std::string& footer);

  /// Adds --version, and --describe FOLDER, which writes manual pages and shell completion there.
  void add_own_options() { has_own_options_ = true; }

  /// Every option and operand of the command that a settings file may give.
  [[nodiscard]] std::vector<SettableOption> options_of(std::string_view command) const;

  /// Runs the command that the arguments (the first is the program's name) select, or prints help. Throws UsageError
  /// with a one-line message, and exceptions of the command.
  void run(std::span<char* const> arguments);

  /// Runs the command that the first word names, with settings recorded in another file; `watch` observes its run.
  /// Reads no settings file. Throws as the other overload does, and InputError with a setting's place.
  void run(std::vector<std::string> words, std::span<const Setting> settings, const RunWatch& watch = {});

 private:
  struct Read;

  [[nodiscard]] Command* find_command(std::string_view name);
  [[nodiscard]] Read read_words(std::span<const std::string> arguments, bool takes_settings);
  [[nodiscard]] std::vector<std::string> command_names() const;
  void print_help(std::span<const std::string> words) const;
  [[nodiscard]] bool try_program_options(std::span<const std::string> arguments) const;
  [[nodiscard]] std::vector<Setting> read_command_settings(const std::string& file, const Command& command) const;
  void run_with_error_context(std::span<const std::string> arguments, const std::function<void()>& act);

  std::string description_;
  std::string program_;
  bool has_own_options_ = false;
  std::deque<Command> commands_;
};

}  // namespace csgsim::shell
