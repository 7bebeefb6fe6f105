#include "sim/software/convert/boundary.h"

#include <optional>
#include <utility>
#include <vector>

#include "host/csg/positive_tree.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/convert/exact_outlines.h"
#include "sim/software/convert/fragments.h"
#include "sim/software/convert/outlines.h"
#include "sim/software/convert/side_by_side.h"

namespace csgsim::software::convert {

Outlines boundary(const model::Tree& tree, const facet::Faceting& faceting, const Work& work, unsigned threads) {
  if (tree.root == model::no_index) return {};
  const csg::PositiveTree positive = csg::make_positive_tree(tree);
  const Bodies bodies = make_bodies(tree, faceting, work);
  const auto joined = [&](const std::vector<bool>& whole) {
    ExactOutlines exact(bodies);
    const FragmentSink sink = [&](std::span<const Fragment> found) { exact.add(found); };
    find_fragments(bodies, positive, whole, sink, work, threads);
    exact.close();
    exact.add_whole(whole);
    return join(bodies, std::move(exact));
  };
  if (std::optional<Outlines> outlines = joined(side_by_side(bodies, positive, work))) return *std::move(outlines);
  return joined(std::vector<bool>(bodies.bodies.size(), false)).value();
}

}  // namespace csgsim::software::convert
