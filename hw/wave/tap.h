// Signals that waves show.
// Used by hw and sim/waves.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::wave {

/// Format in which a viewer shows a tap.
enum class Show : std::uint8_t { bits, number, hexadecimal, text };

/// Value of a wire or register in a clock; empty if there is no valid value.
using Number = std::optional<std::uint64_t>;

/// A signal of a machine. The sampled object must outlive the tap.
struct Tap {
  /// Words of letters, digits and `_`, joined by dots; the last word names the signal, the words before it name the
  /// part.
  std::string name;
  Show show = Show::bits;
  unsigned width = 1;                 ///< number of bits, at most 64; 0 for a text
  std::function<Number()> number;     ///< null for a text
  std::function<std::string()> text;  ///< null for a number; returns an empty string if there is no valid value
};

inline Tap bit(std::string name, std::function<Number()> number) {
  return {std::move(name), Show::bits, 1, std::move(number), nullptr};
}
inline Tap bits(std::string name, unsigned width, std::function<Number()> number) {
  return {std::move(name), Show::bits, width, std::move(number), nullptr};
}
inline Tap number(std::string name, unsigned width, std::function<Number()> number) {
  return {std::move(name), Show::number, width, std::move(number), nullptr};
}
inline Tap hexadecimal(std::string name, unsigned width, std::function<Number()> number) {
  return {std::move(name), Show::hexadecimal, width, std::move(number), nullptr};
}
inline Tap text(std::string name, std::function<std::string()> text) {
  return {std::move(name), Show::text, 0, nullptr, std::move(text)};
}

/// Appends `more` to `taps`.
void add(std::vector<Tap> more, std::vector<Tap>& taps);

/// Converts `name` to a valid word of a tap's name: other characters than letters, digits and `_` become `_`.
std::string identifier(std::string_view name);

}  // namespace csgsim::wave
