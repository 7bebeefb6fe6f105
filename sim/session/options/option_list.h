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
/// by the same list, give texts to its options by name, and take them: what is refused, and in which words, is decided
/// here.
namespace csgsim::session {

/// What is wrong with an option's text, or nothing.
using Check = std::function<std::string(const std::string&)>;

/// What an option takes.
enum class Takes : std::uint8_t {
  flag,          ///< nothing, or true or false
  whole_number,  ///< 0 or more
  number,
  text,
  texts,  ///< any number of them
};

/// An option of a command, or an operand of it, by its key: the long name without dashes, or the operand's in small
/// letters.
struct SettableOption {
  std::string name;
  Takes takes = Takes::text;
};

/// An option or operand with the value that it has, given or by default.
struct OptionValue : SettableOption {
  bool is_operand = false;
  std::string meaning;
  std::vector<std::string> values;  ///< none where nothing is said
};

/// An option that was given.
struct GivenOption {
  std::string name;   ///< the long one, without dashes
  std::string value;  ///< all values, with commas
  bool is_default = false;
};

/// What is wrong with a name of a file or folder, or nothing.
std::string not_empty(const std::string& name);

/// An option or operand: what it is called and means, which texts it takes, and where its value goes. Functions that
/// return it say one thing more of it.
class Option {
 public:
  Option& required();
  Option& check(const Check& check);

  /// One of these words. Messages call a word a `kind`, or by the option's name if no kind is given.
  Option& one_of(const std::vector<std::string>& all, const std::string& kind = {});

  /// A list of them with commas, as one text.
  Option& list_of(const std::vector<std::string>& all, const std::string& kind);

  /// A text that is made of these words, as the check says.
  Option& words(const std::vector<std::string>& words, const Check& check);

  template <class Value>
  Option& one_of(const std::map<std::string, Value>& named, const std::string& kind = {}) {
    std::vector<std::string> all;
    all.reserve(named.size());
    for (const auto& [name, value] : named) all.push_back(name);
    return one_of(all, kind);
  }

  /// The name of a folder, which may not be empty.
  Option& folder();

  /// A whole number, both limits included.
  Option& between(std::uint64_t low, std::uint64_t high);

  /// One may not be given with the other, which is named with its dashes.
  Option& excludes(const std::string& other);

  /// What is wrong with texts that are given to it, or nothing.
  [[nodiscard]] std::string problem(std::span<const std::string> texts) const;

  [[nodiscard]] bool is_given() const { return !given.empty(); }
  [[nodiscard]] std::string key() const;                      ///< as in SettableOption
  [[nodiscard]] bool is_called(std::string_view name) const;  ///< by its key, or another long name without dashes
  [[nodiscard]] std::string shown_name() const;               ///< `--z-bits`, or `MODEL`
  [[nodiscard]] std::string value_text() const;               ///< the given texts, with commas
  [[nodiscard]] OptionValue value() const;

  std::vector<std::string> names;  ///< with dashes, short ones first; of an operand its only one
  Takes takes = Takes::text;
  std::string meaning;
  std::string usual;                 ///< what it is if it is not given; empty if nothing is said
  std::vector<std::string> offered;  ///< words that it is made of; none if it takes any text
  std::string range;                 ///< of its numbers, as in `4 to 30`
  std::vector<std::string> excluded;
  bool is_operand = false;
  bool is_required = false;
  bool is_folder = false;
  std::vector<std::string> given;  ///< texts, in their order
  std::string place;               ///< file:line:column, where a settings file gives them

 private:
  friend class OptionList;

  std::vector<Check> checks_;
  std::function<void(const std::vector<std::string>&)> take_;
};

/// Callbacks of a run's caller.
struct RunWatch {
  std::function<void(const nlohmann::ordered_json& configuration)> before;  ///< it may throw
  std::function<void(const nlohmann::ordered_json& stats)> after;           ///< when all is written
};

/// The options of one request. The values have to live as long; what they hold before they are taken is the default,
/// which help shows.
class OptionList {
 public:
  explicit OptionList(std::string name) : name_(std::move(name)) {}
  OptionList(const OptionList&) = delete;
  OptionList& operator=(const OptionList&) = delete;

  /// Adds an option with a text, a number, several texts, or an optional number, which has no default. Names are
  /// separated by commas: `-o,--output`; a name without a dash is an operand's: `MODEL`.
  template <class Value>
  Option& option(const std::string& names, Value& value, const std::string& meaning);

  /// An option whose text `take` reads; it may throw UsageError.
  Option& read_option(const std::string& names, const std::function<void(const std::string&)>& take,
                      const std::string& meaning);
  Option& flag(const std::string& names, bool& is_given, const std::string& meaning);

  /// Takes back an option of a group that makes no sense for this request.
  void remove(const std::string& shown_name);

  /// Forgets what was given.
  void clear();

  /// Gives a text to the option with that key, or to the next operand. Throws UsageError for a key that no option has,
  /// with the nearest.
  void give(std::string_view key, const std::string& text);
  void give_flag(std::string_view key);  ///< UsageError too for an option that needs a text
  void give_operand(const std::string& text);

  /// Gives what words say that csgsim has written, as words() does: options by their long names, and operands. Throws
  /// UsageError.
  void give_words(std::span<const std::string> words);

  /// Writes the values of what was given. Throws UsageError for what is not as it has to be; InputError with the place
  /// if that is a settings file's.
  void take_given();

  /// The same, if nothing is missing and nothing is given that excludes another. Throws UsageError where it is.
  void take();

  /// What is given and may not be given with the option; null if nothing is.
  [[nodiscard]] const Option* excluded_by(const Option& option) const;

  /// The place of the settings file that gave the option with which a message begins, or nothing.
  [[nodiscard]] std::string place_of(std::string_view message) const;

  [[nodiscard]] const std::string& name() const { return name_; }  ///< of the request: `render`
  [[nodiscard]] std::deque<Option>& all() { return options_; }
  [[nodiscard]] const std::deque<Option>& all() const { return options_; }
  [[nodiscard]] const Option* find(std::string_view key) const;
  [[nodiscard]] Option* find(std::string_view key);

  /// Is the option with that key given?
  [[nodiscard]] bool is_given(std::string_view key) const;

  /// Options, without operands, in the order of help.
  [[nodiscard]] std::vector<GivenOption> given() const;

  /// Every option and operand, in the order of help.
  [[nodiscard]] std::vector<OptionValue> values() const;
  [[nodiscard]] std::vector<SettableOption> settable() const;

  /// What was given, as words of a command line: the request's name, its operands, and each option, but for those
  /// named, by its long name. Given again, they say the same.
  [[nodiscard]] std::vector<std::string> words(std::span<const std::string_view> but = {}) const;

  /// The command line that asks for this, whose first word is the program: as it was typed, if it was.
  [[nodiscard]] std::vector<std::string> arguments() const;

  std::vector<std::string> typed;  ///< what arguments() returns; if empty, it is made of words()
  RunWatch watch;

 private:
  Option& add(const std::string& names, Takes takes, const std::string& meaning);
  [[nodiscard]] Option& named(std::string_view key);

  std::string name_;
  std::deque<Option> options_;  ///< which stay where they are
};

/// An option with its value as words of a command line: two, or one where the value would be taken for an option.
std::vector<std::string> option_words(const std::string& name, const std::string& value);

/// A command line of csgsim for a POSIX shell, of the words after the program's name.
std::string shell_command(std::span<const std::string> words);

/// A question after a blank, or nothing where no known word is like it.
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

/// The message about an option, with its dashes, that the request does not have.
std::string no_such_option(std::string_view word, std::span<const std::string> known, std::string_view request);

}  // namespace csgsim::session
