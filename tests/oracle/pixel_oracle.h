#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"

namespace csgsim::testing {

/// The visible surface at a pixel.
struct Seen {
  std::uint32_t depth = 0;  ///< in depth steps; all ones for the background
  std::uint32_t owner = 0;  ///< index of the primitive; ~0 for the background

  bool operator==(const Seen&) const = default;
};

/// Draws the picture by the rules alone, pixel by pixel, from the fixed-point planes and quadrics of a view. Every
/// primitive is the interval [front, back) of its ray, and empty outside its rectangle of pixels. The visible end (the
/// front of an added primitive, the back of a subtracted one) is classified by the tree as stated in the model, with
/// half-open intervals. The nearest end that no operator removes is visible; of several at one depth, the first in tree
/// order. No pruning, positive form or instructions are involved: this is an independent judge of those.
std::vector<Seen> draw_by_rules(const model::Tree& tree, const facet::Geometry& scene, const view::View& view);

}  // namespace csgsim::testing
