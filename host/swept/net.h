// Bicubic B-spline surfaces given by a net of control points.
// Used by host/commands.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/swept/surface.h"

namespace csgsim::swept {

/// A surface of uniform bicubic B-spline patches: at least 4 `rows` of at least 4 points; all rows have the same
/// length. N rows of M points make (M - 3) x (N - 3) patches.
struct Net {
  std::vector<std::vector<glm::dvec3>> rows;
};

/// The error in a net and how to fix it; empty if the net is valid.
std::string validation_error(const Net& net);

/// The surface of a valid net.
std::unique_ptr<Surface> make_surface(const Net& net);

}  // namespace csgsim::swept
