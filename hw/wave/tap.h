// Signals that waves show.
// Used by all SystemC machines and sim/waves.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Taps: the signals of a machine that waves show.
namespace csgsim::wave {

/// How a viewer shows a tap.
enum class Show : std::uint8_t { bits, number, hexadecimal, text };

/// Value of a wire or register in a clock; empty if it carries nothing.
using Number = std::optional<std::uint64_t>;

/// A signal of a machine. The sampled object must outlive the tap.
struct Tap {
  std::string name;  ///< words of letters, digits and `_`, joined by dots: the last word names the signal, the words
                     ///< before it name the part
  Show show = Show::bits;
  unsigned width = 1;                 ///< bits, at most 64; 0 for a text
  std::function<Number()> number;     ///< null for a text
  std::function<std::string()> text;  ///< null for a number; returns an empty string for no value
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

/// A valid word for a tap's name: other characters become `_`.
std::string identifier(std::string_view name);

}  // namespace csgsim::wave
