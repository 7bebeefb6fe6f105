#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

namespace csgsim::csg {

/// Points that are looked at together: lists of coordinates are as long as some times so many.
inline constexpr std::size_t farthest_row = 8;

/// The number of the first of the points that are farthest along a direction; as many as there are if none is found,
/// since something is not a number, or the processor has no vectors of doubles. `axes`: the points' coordinates, an
/// axis each.
std::size_t first_farthest(const std::array<std::span<const double>, 3>& axes, const glm::dvec3& direction);

}  // namespace csgsim::csg
