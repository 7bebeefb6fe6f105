#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace csgsim::solids {

/// What resize() of OpenSCAD 2021.01 is given.
enum class Resized : std::uint8_t {
  one,       ///< a solid by itself: new sizes that are not positive count as 0
  combined,  ///< what a Boolean has made: a negative new size mirrors
};

/// How resize() of OpenSCAD scales a solid of that size about the origin: to each new size that is not 0; other axes
/// not at all, or, if they are automatic, as much as the axis of the largest new size. Not at all if the solid is flat
/// along an axis that has a new size.
glm::dvec3 resize_scale(const glm::dvec3& size, const glm::dvec3& new_size, const std::array<bool, 3>& automatic,
                        Resized what);

}  // namespace csgsim::solids
