#include "sim/software/convert/boundary.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "host/csg/positive_tree.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/convert/fragments.h"

namespace csgsim::software::convert {

Outlines boundary(const model::Tree& tree, const facet::Faceting& faceting, const Work& work) {
  if (tree.root == model::no_index) return {};
  const csg::PositiveTree positive = csg::make_positive(tree);
  for (const Neighbours neighbours : {Neighbours::corner, Neighbours::all}) {
    const Bodies bodies = make_bodies(tree, faceting, neighbours);
    if (std::optional<Outlines> outlines = join(bodies, fragments(bodies, positive, work))) return *std::move(outlines);
  }
  throw std::logic_error("the boundary of the model is not closed");
}

}  // namespace csgsim::software::convert
