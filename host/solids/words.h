#pragma once

#include <cstdint>
#include <string_view>

namespace csgsim::solids {

/// The words of a text, between blanks and line ends, and where they are.
class Words {
 public:
  /// Both have to outlive this. A comment runs from that character to the end of its line; 0: there are none.
  Words(std::string_view text, std::string_view name, char comment = 0) : text_(text), name_(name), comment_(comment) {}

  /// The next word; empty at the end of the text.
  std::string_view next();

  /// The next word if it is on the line of the last one; else empty, and the word is still the next.
  std::string_view next_on_line();

  /// What is left of the line of the last word is passed over.
  void skip_line();

  /// The next word as a finite number.
  double number(std::string_view what) { return number_of(next(), what); }

  /// The last word as one.
  [[nodiscard]] double number_of(std::string_view word, std::string_view what) const;

  /// The next word as a whole number that is not above the most.
  std::uint32_t count(std::string_view what, std::uint32_t most);

  /// Throws InputError at the last word: `name:line:column: message`.
  [[noreturn]] void fail(std::string_view message) const;

 private:
  void skip_blanks(bool over_lines);
  std::string_view take();

  std::string_view text_;
  std::string_view name_;
  char comment_;
  std::size_t at_ = 0;
  std::size_t word_at_ = 0;  ///< of the last word
  std::size_t line_at_ = 0;  ///< where the line of at_ begins
  std::size_t word_line_at_ = 0;
  std::uint64_t line_ = 1;  ///< of at_
  std::uint64_t word_line_ = 1;
};

}  // namespace csgsim::solids
