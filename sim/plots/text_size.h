#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace csgsim::plots {

/// Pixels of the font of all texts, and of a line of it with the room above and below.
inline constexpr double font_size = 14;
inline constexpr double line_height = 18;

/// Pixels that a text takes from left to right, at most, in any common sans-serif font: the widest advance of DejaVu
/// Sans, Liberation Sans and Lato for each character of ASCII, bounds for ranges of others.
double text_width(std::string_view text);

/// The text as it is shown in a plot: printable, and where it is wider than so many pixels without its middle.
std::string shortened(std::string_view text, double width);

/// The text in one line or two, parted at a blank where it is wider than so many pixels; each shortened where it is
/// still wider.
std::vector<std::string> in_two_lines(std::string_view text, double width);

/// All of them, so that those that differ still do: where the ends are the same, a number is put in.
std::vector<std::string> shortened(const std::vector<std::string>& texts, double width);

}  // namespace csgsim::plots
