// A spatial index of the machine's regions.
// Used by the plan and the division counts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/csg/box_index.h"
#include "host/csg/convex_sets.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

view::PixelRect region_pixels(const isa::Region& region);

/// Finds the regions that overlap a rectangle of pixels.
class RegionIndex {
 public:
  explicit RegionIndex(std::span<const isa::Region> regions);

  /// Calls visit(number) for each region that overlaps `pixels`, in ascending order.
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

/// The numbers, in ascending order for each region, of the sets whose primitives' rectangles have common pixels with
/// it.
std::vector<std::vector<std::uint32_t>> sets_by_region(std::span<const isa::Region> regions,
                                                       std::span<const csg::ConvexSet> sets, const view::View& view);

}  // namespace csgsim::emit
