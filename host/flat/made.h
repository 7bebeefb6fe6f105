// OpenSCAD's 2-D primitives: square(), circle() and polygon().
// Used by host/read.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::flat {

/// A rectangle with a corner at the origin or, if `center`, centred on it. Empty unless both sides are above 0 and
/// finite.
Area square(const glm::dvec2& size, bool center);

/// A regular polygon inscribed in a circle about the origin, with its first corner on the x axis and as many corners as
/// in OpenSCAD. Empty unless the radius is above 0 and finite.
Area circle(double radius, const model::FacetControl& facets);

/// The points inside an odd number of the paths, which index `points`. If there are no paths, `points` is the only
/// path. Paths may cross and run in either direction. Throws InputError for an index out of range and for coordinates
/// that are not finite or too large, and WorkError if the work limit is exceeded.
Area polygon(std::span<const glm::dvec2> points, std::span<const std::vector<std::uint32_t>> paths,
             const Work& work = {});

}  // namespace csgsim::flat
