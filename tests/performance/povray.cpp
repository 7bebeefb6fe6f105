#include "tests/performance/povray.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace csgsim::bench {

namespace {

std::string text_of(const glm::dvec3& vector) { return fmt::format("<{}, {}, {}>", vector.x, vector.y, vector.z); }

std::string colour_of(const model::Primitive& primitive) {
  return text_of(primitive.colour.value_or(glm::dvec3(0.98, 0.84, 0.17)));
}

/// POV-Ray's plane is the half-space opposite to its normal. Without a box it would test every half-space at every
/// pixel.
std::string solid_text(const facet::Geometry& scene, const facet::Convex& solid, const model::Primitive& primitive) {
  std::string text = "intersection {\n";
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    const facet::Plane& plane = scene.planes.planes()[halfspace.plane];
    const double sign = halfspace.positive ? 1 : -1;
    const double offset = plane.offset - glm::dot(plane.normal, scene.planes.centre());
    text += fmt::format("  plane {{ {}, {} }}\n", text_of(plane.normal * sign), -offset * sign);
  }
  return text + fmt::format("  bounded_by {{ box {{ {}, {} }} }}\n  pigment {{ rgb {} }}\n}}\n", text_of(solid.box.low),
                            text_of(solid.box.high), colour_of(primitive));
}

const char* word_of(model::Operator op) {
  switch (op) {
    case model::Operator::unite: return "union";
    case model::Operator::subtract: return "difference";
    case model::Operator::intersect: return "intersection";
  }
  return "";
}

std::string camera_text(const view::Camera& camera) {
  const view::Basis basis = view::basis(camera);
  const double side = 2 * view::half_height(camera);
  return fmt::format(
      "#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\nbackground {{ rgb 1 }}\n"
      "camera {{ orthographic location {} direction {} right {} up {} }}\nlight_source {{ {}, rgb 1 shadowless }}\n",
      text_of(camera.eye), text_of(basis.forward), text_of(basis.right * side), text_of(basis.up * side),
      text_of(camera.eye));
}

}  // namespace

std::string povray_scene(const model::Tree& tree, const facet::Geometry& scene, const view::Camera& camera) {
  std::vector<std::string> texts;
  texts.reserve(tree.nodes.size());
  for (const model::Node& node : tree.nodes) {
    if (node.is_leaf) {
      texts.push_back(solid_text(scene, scene.solids[node.primitive], tree.primitives[node.primitive]));
      continue;
    }
    std::string text = std::string(word_of(node.op)) + " {\n";
    for (const std::uint32_t child : node.children) text += std::exchange(texts[child], {});
    texts.push_back(text + "}\n");
  }
  return camera_text(camera) + (tree.root == model::no_index ? "" : texts[tree.root]);
}

}  // namespace csgsim::bench
