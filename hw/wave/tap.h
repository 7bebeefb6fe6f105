#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a wave shows of a machine, and the file that it is kept in.
namespace csgsim::wave {

/// How a viewer shows a tap.
enum class Show : std::uint8_t { bits, number, hexadecimal, text };

/// What is on a wire or in a register in a clock, or nothing.
using Number = std::optional<std::uint64_t>;

/// A place of a machine that a wave shows. What it samples has to live as long as the tap.
struct Tap {
  std::string name;  ///< words of letters, digits and `_`, with dots between them: the last is the wire's, the others
                     ///< are the part's that it belongs to
  Show show = Show::bits;
  unsigned width = 1;                 ///< bits, 64 at most; 0 for a text
  std::function<Number()> number;     ///< null for a text
  std::function<std::string()> text;  ///< null for a number; an empty one is nothing
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

/// Puts more taps behind those that there are.
void add(std::vector<Tap> more, std::vector<Tap>& taps);

/// A name made of such words: what else it holds becomes `_`.
std::string identifier(std::string_view name);

}  // namespace csgsim::wave
