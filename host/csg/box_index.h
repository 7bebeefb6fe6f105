#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::csg {

/// Boxes of four dimensions, found by what they meet: columns, rows, depths, and whatever a caller numbers. Coordinates
/// are floats, and become so by rounding that keeps their order: integers that are not told apart by a float count as
/// equal, so that what is found holds what was asked for, and may hold a little more.
class BoxIndex {
 public:
  struct Box {
    std::array<float, 4> low{};
    std::array<float, 4> high{};
  };
  struct Entry {
    Box box;  ///< no low above its high
    std::uint32_t number = 0;
  };

  explicit BoxIndex(std::span<const Entry> entries);

  /// Boxes that a way from the root down to the entries looks at, where nodes are full: what a question takes besides
  /// what it finds.
  [[nodiscard]] std::uint64_t boxes_of_way() const;

  /// Appends the numbers of the entries that have a point in common with the box, the least first.
  void meeting(const Box& box, std::vector<std::uint32_t>& numbers) const;

  /// The numbers of the entries that hold the whole box, the least first; of more than `most` the least ones.
  [[nodiscard]] std::vector<std::uint32_t> covering(const Box& box, std::size_t most) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

/// Pixels, depths and numbers from the first to the last; an interval of depths may be given either way round.
BoxIndex::Box picture_box(const view::PixelRect& pixels, std::int64_t z_low, std::int64_t z_high,
                          std::uint32_t first = 0, std::uint32_t last = 0);

}  // namespace csgsim::csg
