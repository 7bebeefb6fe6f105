#pragma once

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/shell/settings/settings_file.h"

// The library that reads the command line takes seconds to compile; only command_line.cpp and settings_app.cpp include
// it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace csgsim::shell {

/// What is wrong with an option's text, or nothing.
using Check = std::function<std::string(const std::string&)>;

/// An option that is being described: each call says one thing more.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option& required();
  Option& check(const Check& check);

  /// One of these words, each of which is called a `kind`: the option's name if it is not given.
  Option& one_of(const std::vector<std::string>& names, const std::string& kind = {});

  /// A list of them with commas, as one text.
  Option& list_of(const std::vector<std::string>& names, const std::string& kind);

  /// A text that is made of these words, as the check says.
  Option& words(const std::vector<std::string>& words, const Check& check);

  template <class Value>
  Option& one_of(const std::map<std::string, Value>& named, const std::string& kind = {}) {
    std::vector<std::string> names;
    names.reserve(named.size());
    for (const auto& [name, value] : named) names.push_back(name);
    return one_of(names, kind);
  }

  /// The name of a folder, which may not be empty.
  Option& folder();

  /// Both limits included; help shows the type.
  template <class Number>
  Option& between(Number low, Number high);

  /// One may not be given with the other.
  Option& excludes(const std::string& other);

 private:
  CLI::Option* option_;
};

/// An option that was given.
struct GivenOption {
  std::string name;   ///< the long one, without dashes
  std::string value;  ///< all values, with commas
  bool is_default = false;
};

/// What a command that runs commands wants to see of them.
struct RunWatch {
  std::function<void(const nlohmann::ordered_json& configuration)> before;  ///< of a run; it may throw
  std::function<void(const nlohmann::ordered_json& stats)> after;           ///< when all is written
};

/// An option with its value as words of a command line: two, or one where the value would be taken for an option.
std::vector<std::string> option_words(const std::string& name, const std::string& value);

/// A command that is being described. Values are written when the command line is read, and have to live until then;
/// what they hold before is the default, which help shows. A name without a dash is of an operand: `MODEL`.
class Command {
 public:
  explicit Command(CLI::App& command) : command_(&command) {}

  /// Of a text, a number, several texts, or an optional number, which has no default.
  template <class Value>
  Option option(const std::string& names, Value& value, const std::string& help);

  /// An option whose text `take` reads; it may throw UsageError.
  Option read_option(const std::string& names, const std::function<void(const std::string&)>& take,
                     const std::string& help);
  void flag(const std::string& names, bool& is_given, const std::string& help);

  /// Adds --quiet: nothing is printed, whatever the command prints.
  void prints_summary();

  /// Takes back an option of a group that makes no sense for this command.
  void remove(const std::string& option);

  /// What the command does, when the command line has been read.
  void runs(const std::function<void()>& action);

  [[nodiscard]] const std::string& name() const;

  /// Options, without operands, in the order of help.
  [[nodiscard]] std::vector<GivenOption> given() const;

  /// Every option and operand but --help and --config, in the order of help.
  [[nodiscard]] std::vector<OptionValue> values() const;

  /// The command line, whose first word is the program; if it was asked for by settings alone, one that asks the same.
  [[nodiscard]] std::vector<std::string> arguments() const;

  [[nodiscard]] RunWatch& watch() const;

  /// The command line as it was read: the command's name, its operands, and each option, but for those named, by its
  /// long name. Read again, it says the same.
  [[nodiscard]] std::vector<std::string> words(std::span<const std::string_view> but) const;

 private:
  CLI::App* command_;
};

/// A command line that asks for one of several commands.
class CommandLine {
 public:
  CommandLine(const std::string& description, const std::string& program);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Command add(const std::string& name, const std::string& description, const std::string& footer);

  /// Adds --version, and --describe FOLDER, which writes manual pages and shells' completion there.
  void add_own_options();

  /// Every option and operand of the command that settings know.
  [[nodiscard]] std::vector<SettableOption> options_of(const std::string& command) const;

  /// Runs the command that the arguments (the first is the program's name) ask for, or prints the help they ask for.
  /// Throws UsageError with one line for people, and what the command throws.
  void run(std::span<char* const> arguments);

  /// Runs the command that the first of the words, which are of csgsim itself, names, with settings besides that come
  /// from somebody else. Nothing but the words can name a settings file. Throws as run does, and InputError with a
  /// setting's place.
  void run(std::vector<std::string> words, std::vector<Setting> settings);

  /// Reads a command's name and its options without running anything, and returns them as Command::words(but) tells
  /// them. Throws UsageError for words that ask for no command of this line, or for help.
  [[nodiscard]] std::vector<std::string> read(std::vector<std::string> words, std::span<const std::string_view> but);

 private:
  void parse(std::span<char* const> arguments, const std::function<void()>& load);

  std::unique_ptr<CLI::App> app_;
};

}  // namespace csgsim::shell
