#include "sim/software/convert/boundary.h"

#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "host/csg/positive_tree.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/convert/fragments.h"
#include "sim/software/convert/side_by_side.h"

namespace csgsim::software::convert {

Outlines boundary(const model::Tree& tree, const facet::Faceting& faceting, const Work& work, unsigned threads) {
  if (tree.root == model::no_index) return {};
  const csg::PositiveTree positive = csg::make_positive(tree);
  for (const Neighbours neighbours : {Neighbours::corner, Neighbours::all}) {
    const Bodies bodies = make_bodies(tree, faceting, neighbours);
    const std::vector<bool> none(bodies.bodies.size(), false);
    const std::vector<bool> whole = neighbours == Neighbours::all ? none : side_by_side(bodies, positive, work);
    std::optional<Outlines> outlines = join(bodies, whole, fragments(bodies, positive, whole, work, threads));
    if (!outlines && whole != none) outlines = join(bodies, none, fragments(bodies, positive, none, work, threads));
    if (outlines) return *std::move(outlines);
  }
  throw std::logic_error("the boundary of the model is not closed");
}

}  // namespace csgsim::software::convert
