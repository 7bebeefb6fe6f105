#include "sim/software/convert/boundary.h"

#include <optional>
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
  const Bodies bodies = make_bodies(tree, faceting, work);
  const std::vector<bool> whole = side_by_side(bodies, positive, work);
  if (std::optional<Outlines> outlines = join(bodies, whole, fragments(bodies, positive, whole, work, threads)))
    return *std::move(outlines);
  const std::vector<bool> none(bodies.bodies.size(), false);
  return join(bodies, none, fragments(bodies, positive, none, work, threads)).value();
}

}  // namespace csgsim::software::convert
