// OpenSCAD's surface(): meshes of height fields.
// Used by host/read.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "host/solids/mesh.h"
#include "hw/base/input_file.h"

namespace csgsim::solids {

/// Maximum number of heights in a grid.
inline constexpr std::size_t max_heights = 1'000'000;

inline constexpr InputKind surface_file{"a surface file", std::size_t{1} << 26U, "make it coarser"};

/// Builds the mesh of OpenSCAD's surface(): heights over a grid of unit cells. Each cell has four triangles that meet
/// above its centre, at the mean height of its corners. Walls lead down to a floor, which is at 0 or 1 below the lowest
/// height, whichever is lower. A file whose name ends with .png has pixels; any other file has numbers. Fewer than two
/// rows or columns give an empty mesh. `bytes` is the content of the file; its name appears in messages. Throws
/// InputError with the file name and, where known, the position in it.
Mesh parse_surface_file(std::string_view bytes, const std::filesystem::path& path, bool center, bool invert);

/// Parses numbers separated by blanks, one row per line; the first row is along y = 0. Lines that begin with # are
/// skipped. Short rows are padded with zeros.
Mesh parse_surface(std::string_view text, std::string_view name, bool center);

/// Parses a PNG picture. Heights are the luminance of the pixels times 100 / 255; the last row is along y = 0.
/// Inversion computes 1 - luminance, as in OpenSCAD, and not white - luminance. Alpha and gamma are ignored.
Mesh parse_surface_png(std::string_view bytes, std::string_view name, bool center, bool invert);

}  // namespace csgsim::solids
