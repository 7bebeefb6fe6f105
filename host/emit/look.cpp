#include "host/emit/look.h"

#include "hw/isa/colour_format.h"

namespace csgsim::emit {

std::uint32_t packed_colour(const glm::dvec3& colour, unsigned colour_bits) {
  return isa::pack_colour({colour.r, colour.g, colour.b}, colour_bits);
}

std::uint32_t packed_background(const scene::Scene& scene, unsigned colour_bits) {
  return packed_colour(scene.background.colour.value_or(lighting::background_colour), colour_bits);
}

Look make_look(const scene::Scene& scene, const model::Tree& tree, const csg::PositiveTree& positive,
               const view::Camera& camera) {
  Look look{lighting::make_lighting(scene, camera), {}};
  look.finishes.reserve(tree.primitives.size());
  bool is_cut = false;
  for (std::size_t i = 0; i < tree.primitives.size(); ++i) {
    // The first piece of a node decides for all its pieces: what the node itself subtracts is a hole, not a cut.
    if (!tree.primitives[i].continues) is_cut = positive.nodes[positive.leaf_of[i]].complemented;
    look.finishes.push_back(lighting::make_finish(scene, tree.primitives[i], is_cut));
  }
  return look;
}

}  // namespace csgsim::emit
