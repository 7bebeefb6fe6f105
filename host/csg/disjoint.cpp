#include "host/csg/disjoint.h"

#include "host/csg/separation.h"

namespace csgsim::csg {

bool disjoint(const facet::Box& a, const facet::Box& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.low[axis] > b.high[axis] || b.low[axis] > a.high[axis]) return true;
  }
  return false;
}

bool disjoint(const view::View& view, std::uint32_t a, std::uint32_t b, const Pruning& pruning) {
  const view::Extent& first = view.extents[a];
  const view::Extent& second = view.extents[b];
  const bool in_picture =
      common(first.pixels, second.pixels).empty() || first.z_low > second.z_high || first.z_high < second.z_low;
  return (pruning.picture && in_picture) || (pruning.space && disjoint(first.box, second.box)) ||
         (pruning.separation && separated(first.corners, second.corners));
}

}  // namespace csgsim::csg
