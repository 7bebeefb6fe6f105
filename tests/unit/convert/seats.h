#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace csgsim::testing {

/// A plane seen from outside: `outward` points to the viewer, who sees a turn from `right` to `up` as
/// counter-clockwise.
struct Seat {
  glm::dvec3 outward;
  glm::dvec3 right;
  glm::dvec3 up;
};

/// Both sides of the three coordinate planes, and an oblique plane.
inline const std::array<Seat, 7> seats{{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                        {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
                                        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                        {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                        {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                                        {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                        {{0.6, 0, 0.8}, {0.8, 0, -0.6}, {0, 1, 0}}}};

}  // namespace csgsim::testing
