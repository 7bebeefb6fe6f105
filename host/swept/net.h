#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/swept/surface.h"

namespace csgsim::swept {

/// A surface of uniform bicubic B-spline patches: `rows` of 4 points or more, 4 or more of these, all as long. N rows
/// of M points are (M - 3) x (N - 3) patches.
struct Net {
  std::vector<std::vector<glm::dvec3>> rows;
};

/// What is wrong with a net, and what to do; empty if nothing is.
std::string fault_of(const Net& net);

/// Of a net without fault.
std::unique_ptr<Surface> surface_of(const Net& net);

}  // namespace csgsim::swept
