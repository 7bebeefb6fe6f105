#pragma once

#include <string>

#include "host/model/tree.h"
#include "sim/software/convert/surface.h"
#include "tests/unit/convert/mesh_judge.h"

namespace csgsim::testing {

software::convert::Surface converted(const model::Tree& tree);

/// Converts the text of a model.
software::convert::Surface converted(const std::string& csg);

JudgedMesh judged(const software::convert::Surface& surface);

/// Whether the tree contains a point, according to the planes of its primitives; `unsure` within `near` of a plane.
enum class Held { in, out, unsure };
Held held_by(const model::Tree& tree, const glm::dvec3& point, double near);

}  // namespace csgsim::testing
