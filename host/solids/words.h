// Tokenizer of text formats, with positions for messages.
// Used throughout host/solids.
#pragma once

#include <cstdint>
#include <string_view>

namespace csgsim::solids {

/// The words of a text, separated by blanks and line ends, with their positions.
class Words {
 public:
  /// `text` and `name` must outlive this object. Comments run from `comment` to the end of the line; 0 means that there
  /// are none.
  Words(std::string_view text, std::string_view name, char comment = 0) : text_(text), name_(name), comment_(comment) {}

  /// The next word; empty at the end of the text.
  std::string_view next();

  /// The next word if it is on the same line as the last one; otherwise empty, without consuming the word.
  std::string_view next_on_line();

  /// Skips the rest of the last word's line.
  void skip_line();

  /// Reads the next word as a finite number; `description` names it in messages.
  double number(std::string_view description) { return number_of(next(), description); }

  /// Parses a word that next() or next_on_line() returned as a finite number.
  [[nodiscard]] double number_of(std::string_view word, std::string_view description) const;

  /// Reads the next word as an integer from 0 to `maximum`.
  std::uint32_t count(std::string_view description, std::uint32_t maximum);

  /// Throws InputError at the last word: `name:line:column: message`.
  [[noreturn]] void fail(std::string_view message) const;

 private:
  void skip_blanks(bool over_lines);
  std::string_view take();

  std::string_view text_;
  std::string_view name_;
  char comment_;
  std::size_t at_ = 0;
  std::size_t word_at_ = 0;  ///< start of the last word
  std::size_t line_at_ = 0;  ///< start of the line of at_
  std::size_t word_line_at_ = 0;
  std::uint64_t line_ = 1;  ///< line of at_
  std::uint64_t word_line_ = 1;
};

}  // namespace csgsim::solids
