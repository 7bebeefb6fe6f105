#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/csg/box_index.h"
#include "host/csg/convex_sets.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

view::PixelRect pixels_of(const isa::Region& region);

/// Finds the regions that a rectangle of pixels has some of.
class RegionIndex {
 public:
  explicit RegionIndex(std::span<const isa::Region> regions);

  /// Calls visit(number) for each of them, the least number first.
  template <class Visit>
  void for_each(const view::PixelRect& pixels, const Visit& visit) {
    if (pixels.empty()) return;
    found_.clear();
    index_.meeting(csg::picture_box(pixels, 0, 0), found_);
    for (const std::uint32_t number : found_) visit(number);
  }

 private:
  csg::BoxIndex index_;
  std::vector<std::uint32_t> found_;
};

/// For each region the numbers of the sets whose primitives' rectangles and the region have pixels in common, in order.
std::vector<std::vector<std::uint32_t>> sets_in(std::span<const isa::Region> regions,
                                                std::span<const csg::ConvexSet> sets, const view::View& view);

}  // namespace csgsim::emit
