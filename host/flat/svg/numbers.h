#pragma once

#include <optional>
#include <string_view>

namespace csgsim::flat::svg {

/// Reads lists of numbers, as attributes of SVG have them, from front to back. What is not there is not taken.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : rest_(text) {}

  /// White space, and one comma in it.
  void skip_separators();

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }

  std::optional<double> number();

  /// 0 or 1, which need not be set apart from what follows.
  std::optional<bool> flag();

  /// A letter of the alphabet.
  std::optional<char> letter();

  /// Letters up to the next character that is none.
  std::string_view word();

  bool take(char character);

 private:
  std::string_view rest_;
};

/// A number and nothing else.
std::optional<double> whole_number(std::string_view text);

}  // namespace csgsim::flat::svg
