#pragma once

#include "host/convex/shadow_volume.h"
#include "tests/unit/convex/support.h"

namespace csgsim::testing {

/// As accurately as rays are judged here, of the diagonal or of the segment.
inline constexpr double doubtful = 1e-7;

/// The greatest height of a point above the volume's planes; below 0 inside.
double height(const TestModel& model, const convex::ShadowVolume& volume, const glm::dvec3& point);

/// Where segments to the light end: at it, or as far away as the model does not reach.
glm::dvec3 end_of_segment(const TestModel& model, const convex::Light& light, const glm::dvec3& point);

/// Along an axis, in any direction, near a solid or in it, far away.
convex::Light random_light(const TestModel& model, RandomPoints& random);

}  // namespace csgsim::testing
