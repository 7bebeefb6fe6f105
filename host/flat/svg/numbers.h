// Parser of number lists in SVG attributes.
// Used throughout host/flat/svg.
#pragma once

#include <optional>
#include <string_view>

namespace csgsim::flat::svg {

/// Reads the lists of numbers in SVG attributes from front to back. A read that fails consumes nothing.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : rest_(text) {}

  /// Skips white space and at most one comma.
  void skip_separators();

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }

  std::optional<double> number();

  /// Reads 0 or 1; no separator is needed after it.
  std::optional<bool> flag();

  /// Reads one letter of the alphabet.
  std::optional<char> letter();

  /// Reads letters up to the next character that is not a letter.
  std::string_view word();

  /// Consumes the character if it is next. Returns whether it was.
  bool take(char character);

 private:
  std::string_view rest_;
};

/// Parses a text that consists of one number.
std::optional<double> parse_single_number(std::string_view text);

}  // namespace csgsim::flat::svg
