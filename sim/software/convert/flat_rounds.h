// Outlines of flat models.
// Used by sim/app.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "sim/software/convert/surface.h"

namespace csgsim::software::convert {

/// Closed rounds of points, counter-clockwise around the shape and clockwise around its holes.
using Rounds = std::vector<std::vector<glm::dvec2>>;

/// The shape of a flat model, from the surface of its plates: the outlines of their upper sides.
Rounds flat_rounds(const Surface& surface);

/// The area in square model units.
double area_of(const Rounds& rounds);

}  // namespace csgsim::software::convert
