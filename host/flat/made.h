#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::flat {

/// A rectangle from the origin, or about it. Empty unless both sides are above 0 and finite.
Area square(const glm::dvec2& size, bool center);

/// A regular polygon in a circle about the origin, the first corner on the x axis, with as many corners as OpenSCAD
/// gives it. Empty unless the radius is above 0 and finite.
Area circle(double radius, const model::FacetControl& facets);

/// What lies within an odd number of the paths, which index the points; without paths, within all points in order.
/// Paths may cross, and run either way. Throws InputError for an index that is no point's, and for coordinates that are
/// not finite or too large, and WorkError past the limit on work.
Area polygon(std::span<const glm::dvec2> points, std::span<const std::vector<std::uint32_t>> paths,
             const Work& work = {});

}  // namespace csgsim::flat
