// Numbers of fragments of circles and spheres, as in OpenSCAD.
// Used by host/facet, host/flat and host/solids.
#pragma once

#include <cstdint>

#include "host/model/tree.h"

namespace csgsim::model {

/// OpenSCAD treats lengths below this as 0: a circle with a smaller radius is a triangle.
inline constexpr double grid_fine = 0.00000095367431640625;

/// Number of corners of the polygon that approximates a circle, as in OpenSCAD. Throws InputError if it exceeds
/// `max_fragments`.
std::uint32_t fragments(double radius, const FacetControl& control);

/// Number of rings of vertices of a sphere whose circles have `fragment_count` fragments, as in OpenSCAD.
constexpr std::uint32_t rings(std::uint32_t fragment_count) { return (fragment_count + 1) / 2; }

inline constexpr std::uint32_t max_fragments = 100'000;

}  // namespace csgsim::model
