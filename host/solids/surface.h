#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "host/solids/mesh.h"
#include "hw/base/input_file.h"

namespace csgsim::solids {

/// Heights at the corners of a grid.
inline constexpr std::size_t most_heights = 1'000'000;

inline constexpr InputKind surface_file{"a surface file", std::size_t{1} << 26U, "make it coarser"};

/// What OpenSCAD's surface() makes of a file: heights above a grid of unit cells, each cell of four triangles that meet
/// in its middle, at the mean of its corners; walls, and a floor one below the least height or one below 1. A file
/// whose name ends with .png has pixels, any other numbers. Heights of which there are not two rows and columns are an
/// empty mesh. The bytes are the file's, and the name is for messages. Throws InputError that names the file, and the
/// place in it where there is one.
Mesh parse_surface_file(std::string_view bytes, const std::filesystem::path& path, bool center, bool invert);

/// Numbers between blanks, a row a line, the first along y = 0; lines that begin with # are left out. Rows that are too
/// short end with zeros.
Mesh parse_surface(std::string_view text, std::string_view name, bool center);

/// Luminance times 100 / 255 of pixels, the last row along y = 0. Inverted, as in OpenSCAD, from 1 instead of white
/// downwards. How clear they are, and their gamma, is not looked at.
Mesh parse_surface_png(std::string_view bytes, std::string_view name, bool center, bool invert);

}  // namespace csgsim::solids
