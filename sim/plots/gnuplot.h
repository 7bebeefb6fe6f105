#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sim/plots/drawing.h"

namespace csgsim::plots {

/// The bytes as a string of gnuplot's that shows them: whatever they are, they end no string and run no command. What
/// printable() does not show stands as its escape.
std::string gnuplot_text(std::string_view bytes);

/// What gnuplot has to be told to draw the picture: gnuplot decides on no place, number or text.
std::string script_of(const Drawing& drawing);

/// A picture in memory, and what gnuplot said besides.
struct Drawn {
  std::string picture;
  std::string said;
};

/// Draws a PNG file. No name of a file is part of what gnuplot reads, and nothing that it says goes any further: where
/// the picture is whole, that is about fonts of the computer. Throws InputError, with the file's name, if gnuplot
/// cannot be run, or draws no whole picture.
Drawn drawn_for(const std::filesystem::path& file, const Drawing& drawing);

}  // namespace csgsim::plots
