#include "sim/software/convert/boundary.h"

#include "host/csg/positive_tree.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/convert/fragments.h"

namespace csgsim::software::convert {

Outlines boundary(const model::Tree& tree, const facet::Faceting& faceting, const Work& work) {
  if (tree.root == model::no_index) return {};
  const Bodies bodies = make_bodies(tree, faceting);
  return join(bodies, fragments(bodies, csg::make_positive(tree), work));
}

}  // namespace csgsim::software::convert
