#pragma once

#include <string>
#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat {

/// What a drawing file holds.
struct Imported {
  Area area;
  std::vector<std::string> left_out;  ///< what it has besides, which OpenSCAD does not draw either; each kind once
};

/// Corners that a drawing may have, at most.
inline constexpr std::size_t max_drawing_corners = 1'000'000;

}  // namespace csgsim::flat
