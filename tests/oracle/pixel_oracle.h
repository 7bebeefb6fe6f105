#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"

namespace csgsim::testing {

/// What is seen at a pixel.
struct Seen {
  std::uint32_t depth = 0;  ///< depth steps; all ones where nothing is seen
  std::uint32_t owner = 0;  ///< primitive; ~0 where nothing is seen

  bool operator==(const Seen&) const = default;
};

/// The picture by the rules alone, pixel by pixel, from the fixed-point planes and quadrics of a view: every primitive
/// is the interval [front, back) of its ray, and nowhere outside its rectangle of pixels; the end that can be seen (the
/// front of what is added, the back of what is taken away) is classified by the tree as the model states it, with the
/// half-open intervals, and the nearest that no operator takes away is the picture's, the first in tree order of
/// several at one depth. No pruning, no positive form, no instructions: a judge of those.
std::vector<Seen> draw_by_rules(const model::Tree& tree, const facet::Geometry& scene, const view::View& view);

}  // namespace csgsim::testing
