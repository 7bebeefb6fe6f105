// Draws a picture with gnuplot.
// Used by files.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sim/plots/drawing.h"

namespace csgsim::plots {

/// The bytes as a quoted gnuplot string. No byte can end the string or run a command; bytes that are not printable are
/// shown as the escapes of printable().
std::string gnuplot_text(std::string_view bytes);

/// The gnuplot script of a picture. All positions, numbers and texts are fixed; gnuplot chooses none.
std::string gnuplot_script(const Drawing& drawing);

/// A PNG picture in memory, and gnuplot's messages.
struct PngResult {
  std::string picture;
  std::string messages;
};

/// Draws a PNG picture. gnuplot reads no file name and its messages are not printed: with a complete picture they
/// concern only the computer's fonts. Throws InputError with the file's name if gnuplot cannot be run or the picture is
/// incomplete.
PngResult draw_png(const std::filesystem::path& file, const Drawing& drawing);

}  // namespace csgsim::plots
