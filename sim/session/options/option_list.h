// Options and operands of a request, with validation and messages.
// Used by sim/python, sim/shell, sim/studies and sim/suite.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The options of a request as plain data. The command line, the page of `view`, Python and studies describe a request
/// by this list, set its options by name and read them. This is the only place that validates options.
namespace csgsim::session {

/// Returns what is wrong with an option's text, or an empty string.
using Check = std::function<std::string(const std::string&)>;

/// The type of an option's value.
enum class Takes : std::uint8_t {
  flag,          ///< no value, or true or false
  whole_number,  ///< 0 or more
  number,
  text,
  texts,  ///< any number of texts
};

/// Key and type of an option or operand of a command. The key is the long name without dashes, or the operand's name in
/// lower case.
struct SettableOption {
  std::string name;
  Takes takes = Takes::text;
};

/// An option or operand with its value, given or default.
struct OptionValue : SettableOption {
  bool is_operand = false;
  std::string meaning;
  std::vector<std::string> values;  ///< empty if there is neither a value nor a default
};

/// An option given by the user.
struct GivenOption {
  std::string name;   ///< the long name, without dashes
  std::string value;  ///< all values, separated by commas
  bool is_default = false;
};

/// Returns what is wrong with a file or folder name, or an empty string.
std::string not_empty(const std::string& name);

/// An option or operand: its names, its meaning, the texts it accepts, and the variable that receives its value.
/// Functions that return the option add one more property.
class Option {
 public:
  Option& required();
  Option& check(const Check& check);

  /// Accepts one of these words. Messages call a word a `kind`, or by the option's name if no kind is given.
  Option& one_of(const std::vector<std::string>& all, const std::string& kind = {});

  /// Accepts a comma-separated list of these words, as one text.
  Option& list_of(const std::vector<std::string>& all, const std::string& kind);

  /// Accepts a text composed of these words; the check validates it.
  Option& words(const std::vector<std::string>& words, const Check& check);

  template <class Value>
  Option& one_of(const std::map<std::string, Value>& named, const std::string& kind = {}) {
    std::vector<std::string> all;
    all.reserve(named.size());
    for (const auto& [name, value] : named) all.push_back(name);
    return one_of(all, kind);
  }

  /// Accepts the name of a folder, which must not be empty.
  Option& folder();

  /// Accepts a whole number in a range, both limits included.
  Option& between(std::uint64_t low, std::uint64_t high);

  /// Forbids the option together with another one, named with its dashes.
  Option& excludes(const std::string& other);

  /// Returns what is wrong with the given texts, or an empty string.
  [[nodiscard]] std::string problem(std::span<const std::string> texts) const;

  [[nodiscard]] bool is_given() const { return !given.empty(); }
  [[nodiscard]] std::string key() const;  ///< see SettableOption
  /// Whether `name` is the key or another of the long names.
  [[nodiscard]] bool is_called(std::string_view name) const;
  [[nodiscard]] std::string shown_name() const;  ///< `--z-bits`, or `MODEL`
  [[nodiscard]] std::string value_text() const;  ///< the given texts, separated by commas
  [[nodiscard]] OptionValue value() const;

  std::vector<std::string> names;  ///< names with dashes, short ones first; one name for an operand
  Takes takes = Takes::text;
  std::string meaning;
  std::string usual;                 ///< default, for help; empty if there is none to show
  std::vector<std::string> offered;  ///< words that a value consists of; empty if any text is accepted
  std::string range;                 ///< range of its numbers, as in `4 to 30`
  std::vector<std::string> excluded;
  bool is_operand = false;
  bool is_required = false;
  bool is_folder = false;
  std::vector<std::string> given;  ///< given texts, in order
  std::string place;               ///< file:line:column of the settings file that gave it

 private:
  friend class OptionList;

  std::vector<Check> checks_;
  std::function<void(const std::vector<std::string>&)> take_;
};

/// Callbacks by which the caller observes a run.
struct RunWatch {
  std::function<void(const nlohmann::ordered_json& configuration)> before;  ///< called before the run; may throw
  std::function<void(const nlohmann::ordered_json& stats)> after;           ///< called after all files are written
};

/// The options of one request. The bound variables have to outlive the list; their initial values are the defaults that
/// help shows.
class OptionList {
 public:
  explicit OptionList(std::string name) : name_(std::move(name)) {}
  OptionList(const OptionList&) = delete;
  OptionList& operator=(const OptionList&) = delete;

  /// Adds an option with a text, a number, several texts, or an optional number, which has no default. Names are
  /// separated by commas, as in `-o,--output`; a name without dashes, as in `MODEL`, is that of an operand.
  template <class Value>
  Option& option(const std::string& names, Value& value, const std::string& meaning);

  /// Adds an option whose text is passed to `take`, which may throw UsageError.
  Option& read_option(const std::string& names, const std::function<void(const std::string&)>& take,
                      const std::string& meaning);
  /// Adds an option without a value; `is_given` becomes true if the option is given.
  Option& flag(const std::string& names, bool& is_given, const std::string& meaning);

  /// Removes an option that a group of options added but that does not apply to this request.
  void remove(const std::string& shown_name);

  /// Clears the given values.
  void clear();

  /// Appends a text to the given texts of the option with that key. Throws UsageError for an unknown key and suggests
  /// the nearest.
  void give(std::string_view key, const std::string& text);
  /// Sets the flag with that key. Throws UsageError for an unknown key, and for an option that needs a value.
  void give_flag(std::string_view key);
  /// Gives the text to the first operand that still accepts one. Throws UsageError if there is none.
  void give_operand(const std::string& text);

  /// Gives the options and operands in the result of words(). Throws UsageError.
  void give_words(std::span<const std::string> words);

  /// Writes the given values to their variables. Throws UsageError for an invalid value, or InputError with the place
  /// for a value of a settings file.
  void apply_given();

  /// Checks that required options are given and that no given option excludes another, then calls apply_given(). Throws
  /// UsageError, or InputError like apply_given().
  void check_and_apply();

  /// A given option that must not be given together with this one; null if there is none.
  [[nodiscard]] const Option* excluded_by(const Option& option) const;

  /// The settings file's place of the option with which a message begins; empty if there is none.
  [[nodiscard]] std::string place_of(std::string_view message) const;

  [[nodiscard]] const std::string& name() const { return name_; }  ///< name of the request, as in `render`
  [[nodiscard]] std::deque<Option>& all() { return options_; }
  [[nodiscard]] const std::deque<Option>& all() const { return options_; }
  [[nodiscard]] const Option* find(std::string_view key) const;
  [[nodiscard]] Option* find(std::string_view key);

  /// Whether the option with that key is given.
  [[nodiscard]] bool is_given(std::string_view key) const;

  /// Given options without operands, in the order of help.
  [[nodiscard]] std::vector<GivenOption> given() const;

  /// Every option and operand, in the order of help.
  [[nodiscard]] std::vector<OptionValue> values() const;
  /// Key and type of every option and operand.
  [[nodiscard]] std::vector<SettableOption> settable() const;

  /// The given options and operands as words of a command line: the request's name, operands, and each option by its
  /// long name, except those with `excluded_keys`. Parsing the words gives the same values.
  [[nodiscard]] std::vector<std::string> words(std::span<const std::string_view> excluded_keys = {}) const;

  /// The command line of this request, whose first word is the program: as typed, if it was typed.
  [[nodiscard]] std::vector<std::string> arguments() const;

  std::vector<std::string> typed;  ///< returned by arguments(); if empty, arguments() uses words()
  RunWatch watch;

 private:
  Option& add(const std::string& names, Takes takes, const std::string& meaning);
  [[nodiscard]] Option& find_required(std::string_view key);

  std::string name_;
  std::deque<Option> options_;  ///< a deque, so that references stay valid
};

/// An option with its value as words of a command line: two, or one if the value could be mistaken for an option.
std::vector<std::string> option_words(const std::string& name, const std::string& value);

/// A csgsim command line for a POSIX shell, from the words after the program's name.
std::string shell_command(std::span<const std::string> words);

/// A suggestion that begins with a blank, or an empty string if no known word is similar.
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

/// The message about an option, with its dashes, that the request does not have.
std::string unknown_option_message(std::string_view word, std::span<const std::string> known, std::string_view request);

}  // namespace csgsim::session
