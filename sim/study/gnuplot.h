#pragma once

#include <filesystem>
#include <string>
#include <string_view>
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

/// The bytes as a string of gnuplot's that shows them: whatever they are, they end no string and run no command. What
/// printable() does not show stands as its escape.
std::string plot_text(std::string_view bytes);

/// The same as the label of a tick, where gnuplot would take a % for a format.
std::string tick_text(std::string_view bytes);

/// The bytes as one string in a line of a data block, where gnuplot knows no escapes: what would end it is left out.
std::string data_text(std::string_view bytes);

/// A file's name without its ending, of at most so many bytes that endings and numbers fit behind it.
std::string plot_stem(const std::filesystem::path& model);

/// Draws folder/name.png and folder/name.svg with a gnuplot script; returns these two. No name of a file is part of
/// what gnuplot reads. Throws InputError if gnuplot cannot be run or does not draw.
std::vector<std::filesystem::path> draw_plot(const std::filesystem::path& folder, const std::string& name,
                                             const std::string& script, PlotSize size = {});

}  // namespace csgsim::study
