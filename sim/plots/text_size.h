// Size of texts in plots.
// Used by the layouts and writers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace csgsim::plots {

/// Font size of all texts, and line height including leading, in pixels.
inline constexpr double font_size = 14;
inline constexpr double line_height = 18;

/// Upper bound of the width of a text in pixels in common sans-serif fonts: the widest advance of DejaVu Sans,
/// Liberation Sans and Lato for each ASCII character, upper bounds for ranges of other characters.
double text_width(std::string_view text);

/// The printable form of the text, with an ellipsis in place of the middle if it is wider than `width` pixels.
std::string shorten(std::string_view text, double width);

/// The text in one line, or in two split at a space if it is wider than `width` pixels; lines that are still too wide
/// are shortened.
std::vector<std::string> split_lines(std::string_view text, double width);

/// Shortens all texts so that different texts stay different: those that become equal get a number.
std::vector<std::string> shorten(const std::vector<std::string>& texts, double width);

}  // namespace csgsim::plots
