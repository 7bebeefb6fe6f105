#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace csgsim::study {

/// Pixels of a plot.
struct PlotSize {
  unsigned width = 800;
  unsigned height = 500;
};

/// Pixels of a character and of a line of text in a plot, at least.
inline constexpr unsigned character_width = 8;
inline constexpr unsigned line_height = 23;

/// Text that gnuplot takes for a string.
std::string quoted(const std::string& text);

/// Runs a gnuplot script for folder/name.png and folder/name.svg; returns these two. Throws InputError if gnuplot
/// cannot be run or does not draw.
std::vector<std::filesystem::path> draw_plot(const std::filesystem::path& folder, const std::string& name,
                                             const std::string& script, PlotSize size = {});

}  // namespace csgsim::study
