#include "sim/plots/palette.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace csgsim::plots::palette {

namespace {

/// Linear value of the two hexadecimal digits from `begin` on (sRGB).
double linear(std::string_view colour, std::size_t begin) {
  unsigned byte = 0;
  std::from_chars(colour.data() + begin, colour.data() + begin + 2, byte, 16);
  const double value = byte / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

double luminance(std::string_view colour) {
  return 0.2126 * linear(colour, 1) + 0.7152 * linear(colour, 3) + 0.0722 * linear(colour, 5);
}

double contrast(std::string_view one, std::string_view other) {
  const auto [dark, light] = std::minmax({luminance(one), luminance(other)});
  return (light + 0.05) / (dark + 0.05);
}

std::string_view readable_text_colour(std::string_view colour) {
  constexpr std::string_view black = "#010101";
  constexpr std::string_view white = "#fefefe";
  return contrast(colour, black) > contrast(colour, white) ? black : white;
}

}  // namespace csgsim::plots::palette
