#include "tests/unit/convert/converted.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/facet/solid.h"
#include "host/read/read.h"
#include "sim/software/convert/boundary.h"
#include "tests/oracle/tree_rules.h"

namespace csgsim::testing {

namespace convert = software::convert;

convert::Surface converted(const model::Tree& tree) { return convert::make_surface(convert::boundary(tree)); }

convert::Surface converted(const std::string& csg) { return converted(read::read_csg_text(csg, "model.csg")); }

JudgedMesh judged(const convert::Surface& surface) {
  JudgedMesh mesh{surface.points, {}};
  for (const convert::Triangle& triangle : surface.triangles) mesh.faces.emplace_back(triangle.begin(), triangle.end());
  return mesh;
}

Held held_by(const model::Tree& tree, const glm::dvec3& point, double near) {
  std::vector<bool> held;
  for (const model::Primitive& primitive : tree.primitives) {
    const facet::Solid solid = facet::make_solid(primitive);
    bool is_in = true;
    for (const facet::Face& face : solid.faces) {
      const double height = face.plane.height(point);
      if (std::abs(height) < near) return Held::unsure;
      is_in = is_in && height < 0;
    }
    held.push_back(is_in);
  }
  return TreeRules(tree).holds(held) ? Held::in : Held::out;
}

}  // namespace csgsim::testing
