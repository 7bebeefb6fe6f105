// Adaptive subdivision of any surface (algorithm 3.1).
// Used by net.cpp and sweep.cpp.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "host/swept/surface.h"
#include "hw/base/error.h"

namespace csgsim::swept {

/// Algorithm 3.1 of the thesis for any surface, with a stack in place of recursion. A `Part` is a square of the
/// surface. `Shape` provides corners(part), is_flat(part, corners, accuracy, counts), and parts(part, counts), which
/// returns the four parts of a part in the order of the corners.
template <class Shape>
class Subdivision : public Stream {
 public:
  using Part = typename Shape::Part;

  Subdivision(Shape& shape, Part whole, const Accuracy& accuracy, SubdivisionCounts& counts)
      : shape_(shape), accuracy_(accuracy), counts_(counts), waiting_{{std::move(whole), {}}} {}

  std::optional<Node> next() override {
    if (waiting_.empty()) return std::nullopt;
    const auto [part, square] = std::move(waiting_.back());
    waiting_.pop_back();
    accuracy_.work.charge(steps, subdividing);
    ++counts_.nodes;
    counts_.points += 4;
    Node node{false, {square, shape_.corners(part)}};
    node.is_leaf = shape_.is_flat(part, node.element.corners, accuracy_, counts_);
    if (node.is_leaf) {
      if (++counts_.elements > most_elements)
        throw InputError(fmt::format("a surface needs more than {} elements; use a coarser tolerance", most_elements));
    } else {
      halve(part, square);
    }
    return node;
  }

 private:
  static constexpr std::string_view subdividing = "subdividing a surface";
  static constexpr std::uint64_t steps = 100;  ///< per node; other work is charged where it is performed
  /// High, because the position along the trajectory is an integral.
  static constexpr std::uint64_t steps_of_section = 2'000;

  void halve(const Part& part, const Square& square) {
    if (square.size <= whole_side >> std::min(accuracy_.max_levels, max_depth))
      throw InputError(
          fmt::format("a surface is not within {} of its elements after {} halvings; use a coarser tolerance, or a "
                      "smoother curve",
                      accuracy_.tolerance, std::min(accuracy_.max_levels, max_depth)));
    const std::uint32_t half = square.size / 2;
    const std::uint64_t sections = counts_.sections;
    std::array<Part, 4> parts = shape_.parts(part, counts_);
    accuracy_.work.charge(steps_of_section * (counts_.sections - sections), subdividing);
    for (std::uint32_t i = 4; i-- > 0;)
      waiting_.push_back({std::move(parts[i]), {square.x + (i % 2) * half, square.y + (i / 2) * half, half}});
  }

  Shape& shape_;
  Accuracy accuracy_;
  SubdivisionCounts& counts_;
  std::vector<std::pair<Part, Square>> waiting_;
};

}  // namespace csgsim::swept
