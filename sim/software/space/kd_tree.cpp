#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/software/space/halving_walk.h"

namespace csgsim::software {

namespace {

/// Cells divided by the surface area heuristic (MacDonald and Booth 1990) at one of 32 positions per axis; a facet's
/// bounding box determines its possible sides.
class KdTree final : public DirectoryOf<KdTree> {
 public:
  KdTree(const FacetShapes& shapes, const SpaceOptions& options)
      : shapes_(shapes), bucket_size_(options.bucket_size), nodes_(1) {
    nodes_[0].facets.assign(shapes.placed().begin(), shapes.placed().end());
    // Maximum depth as in Havran 2000.
    const auto levels = static_cast<unsigned>(8 + 1.3 * static_cast<double>(std::bit_width(shapes.placed().size())));
    divide(0, shapes.box(), levels);
  }

  [[nodiscard]] SpaceBuilt built() const override {
    SpaceBuilt built = built_;
    built.operations = count_.done();
    built.directory_words = 2 * nodes_.size();
    count_buckets(
        nodes_, bucket_size_, [](const Node& node) { return node.low == 0; }, built);
    return built;
  }

  [[nodiscard]] std::vector<SpacePart> parts() const override {
    std::vector<SpacePart> parts;
    for (const Node& node : nodes_) {
      if (node.low == 0) {
        parts.push_back({.box = {}, .facets = node.facets});
      } else {
        parts.push_back({{}, node.axis, node.wall, node.low, node.low + 1});
      }
    }
    // Parents precede their children.
    parts.front().box = shapes_.box();
    for (const Node& node : nodes_) {
      if (node.low == 0) continue;
      const facet::Box& box = parts[static_cast<std::size_t>(&node - nodes_.data())].box;
      const auto [low, high] = halves(box, node.axis, node.wall);
      parts[node.low].box = low;
      parts[node.low + 1].box = high;
    }
    return parts;
  }

  template <class Count>
  void walk_cells(const SpaceRay& ray, CellVisitor& visitor, Count& count) const {
    const auto look = [&](std::uint32_t number, Count& counted) {
      const Node& node = nodes_[number];
      counted(Operation::load_long, 2);
      counted(Operation::branch);
      return Halved<std::uint32_t>{node.low == 0, node.facets, node.axis, node.wall, node.low, node.low + 1};
    };
    walk_halves(shapes_.box(), std::uint32_t{0}, ray, look, visitor, count);
  }

 private:
  static constexpr int places = 32;

  struct Node {
    std::uint32_t low = 0;  ///< the lower child, followed by the upper one; 0 for a cell
    int axis = 0;
    double wall = 0;
    std::vector<std::uint32_t> facets;
  };
  struct Choice {
    int axis = -1;  ///< -1: no division is cheaper than the undivided cell
    double wall = 0;
    double cost = 0;
  };

  static double surface(const facet::Box& box) {
    const glm::dvec3 size = box.high - box.low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
  }

  static std::pair<facet::Box, facet::Box> halves(const facet::Box& box, int axis, double wall) {
    std::pair both{box, box};
    both.first.high[axis] = wall;
    both.second.low[axis] = wall;
    return both;
  }

  /// The cheapest wall of an axis, where a traversal step costs as much as a facet test.
  void choose(const std::vector<std::uint32_t>& facets, const facet::Box& box, int axis, Choice& best) {
    std::array<std::uint64_t, places> begin{};
    std::array<std::uint64_t, places> end{};
    const double width = (box.high[axis] - box.low[axis]) / places;
    const auto place = [&](double at) {
      return static_cast<std::size_t>(std::clamp((at - box.low[axis]) / width, 0.0, places - 1.0));
    };
    for (const std::uint32_t facet : facets) {
      ++begin[place(shapes_.box_of(facet).low[axis])];
      ++end[place(shapes_.box_of(facet).high[axis])];
    }
    count_quotients(count_, 2 * facets.size());
    count_(Operation::load_long, 4 * facets.size());
    count_(Operation::store_long, 2 * facets.size());
    count_products(count_, 6 * std::uint64_t{places});
    std::uint64_t low = 0;
    std::uint64_t high = facets.size();
    for (int i = 1; i < places; ++i) {
      low += begin[static_cast<std::size_t>(i - 1)];
      high -= end[static_cast<std::size_t>(i - 1)];
      const double wall = box.low[axis] + width * i;
      const auto [low_box, high_box] = halves(box, axis, wall);
      const double cost =
          1 +
          (surface(low_box) * static_cast<double>(low) + surface(high_box) * static_cast<double>(high)) / surface(box);
      if (cost < best.cost) best = {axis, wall, cost};
    }
  }

  void divide(std::uint32_t number, const facet::Box& box, unsigned levels) {
    const std::size_t size = nodes_[number].facets.size();
    if (levels == 0 || size <= bucket_size_) return;
    Choice best{-1, 0, static_cast<double>(size)};
    for (int axis = 0; axis < 3; ++axis) choose(nodes_[number].facets, box, axis, best);
    if (best.axis < 0) return;
    ++built_.splits;
    const std::vector<std::uint32_t> facets = std::exchange(nodes_[number].facets, {});
    const auto low = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[number].low = low;
    nodes_[number].axis = best.axis;
    nodes_[number].wall = best.wall;
    const auto [low_box, high_box] = halves(box, best.axis, best.wall);
    built_.overlap_tests += 2 * facets.size();
    for (const std::uint32_t facet : facets) {
      if (shapes_.touches(facet, low_box, count_)) nodes_[low].facets.push_back(facet);
      if (shapes_.touches(facet, high_box, count_)) nodes_[low + 1].facets.push_back(facet);
      count_(Operation::load_long);
      count_(Operation::store_long);
    }
    divide(low, low_box, levels - 1);
    divide(low + 1, high_box, levels - 1);
  }

  const FacetShapes& shapes_;
  std::uint32_t bucket_size_;
  std::vector<Node> nodes_;
  SpaceBuilt built_;
  Counting count_;
};

}  // namespace

extern const DirectoryRow kd_tree_row{
    "kd-tree", "cells divided by the surface area heuristic, visited by clipping the ray to halves",
    "MacDonald and Booth 1990; Havran 2000", make_directory<KdTree>, true};

}  // namespace csgsim::software
