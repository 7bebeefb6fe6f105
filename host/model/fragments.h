#pragma once

#include <cstdint>

#include "host/model/tree.h"

namespace csgsim::model {

/// OpenSCAD takes lengths below this for 0: circles of such a radius are triangles.
inline constexpr double grid_fine = 0.00000095367431640625;

/// Corners of the polygon that stands for a circle of that radius, as OpenSCAD counts them. Throws InputError past
/// `max_fragments`.
std::uint32_t fragments(double radius, const FacetControl& control);

/// Rings of vertices of a sphere whose circles have that many fragments, as OpenSCAD counts them.
constexpr std::uint32_t rings(std::uint32_t fragment_count) { return (fragment_count + 1) / 2; }

inline constexpr std::uint32_t max_fragments = 100'000;

}  // namespace csgsim::model
