// A spatial index of four-dimensional boxes.
// Used by host/effects, host/emit and sim/software.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::csg {

/// An index of boxes in four dimensions: columns, rows, depths, and a number that the caller assigns. Coordinates are
/// rounded monotonically to floats, so that integers with the same float count as equal: a query returns every entry
/// that matches, and possibly some that miss by the rounding.
class BoxIndex {
 public:
  struct Box {
    std::array<float, 4> low{};
    std::array<float, 4> high{};
  };
  struct Entry {
    Box box;  ///< each low is at most its high
    std::uint32_t number = 0;
  };

  explicit BoxIndex(std::span<const Entry> entries);

  /// Number of boxes examined on a path from the root down to the entries, if nodes are full: the cost of a query in
  /// addition to its results.
  [[nodiscard]] std::uint64_t path_boxes() const;

  /// Appends the numbers of the entries that have a point in common with the box, in ascending order.
  void meeting(const Box& box, std::vector<std::uint32_t>& numbers) const;

  /// The numbers, ascending, of the entries that contain the whole box; the lowest `max_count` if there are more.
  [[nodiscard]] std::vector<std::uint32_t> covering(const Box& box, std::size_t max_count) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

/// The box of the pixels, depths and numbers from `first` to `last`; the limits of depths may be in either order.
BoxIndex::Box picture_box(const view::PixelRect& pixels, std::int64_t z_low, std::int64_t z_high,
                          std::uint32_t first = 0, std::uint32_t last = 0);

}  // namespace csgsim::csg
