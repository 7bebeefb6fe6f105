#pragma once

#include "host/convex/shadow_volume.h"
#include "tests/unit/convex/support.h"

namespace csgsim::testing {

/// Tolerance of the ray checks, relative to the diagonal or to the segment.
inline constexpr double doubtful = 1e-7;

/// Maximum signed distance of a point from the volume's planes; negative inside.
double signed_distance(const TestModel& model, const convex::ShadowVolume& volume, const glm::dvec3& point);

/// End of a segment towards the light: the light itself or a point far outside the model.
glm::dvec3 end_of_segment(const TestModel& model, const convex::Light& light, const glm::dvec3& point);

/// A light along an axis, in any direction, near or inside a solid, or far away.
convex::Light random_light(const TestModel& model, RandomPoints& random);

}  // namespace csgsim::testing
