#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace csgsim::csg {

/// Whether a plane is found that strictly separates the hulls of two sets of points. Coordinates may have different
/// units, and a gap may be as small as 1e-9 of the larger hull's. True is certain; false may leave hulls undecided that
/// nearly touch. Sets without points are not separated from anything.
///
/// Gilbert's algorithm (1966) walks towards the point of the Minkowski difference that is nearest to the origin; a
/// support plane that leaves the origin out proves separation.
bool separated(std::span<const glm::dvec3> first, std::span<const glm::dvec3> second);

}  // namespace csgsim::csg
