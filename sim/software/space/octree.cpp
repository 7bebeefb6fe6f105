#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/software/space/lattice.h"

namespace csgsim::software {

namespace {

constexpr unsigned octree_levels = 7;

/// Overfull cells are divided into eight; query points are located from the root (Glassner 1984).
class Octree final : public DirectoryOf<Octree> {
 public:
  Octree(const FacetShapes& shapes, const SpaceOptions& options)
      : shapes_(shapes), bucket_size_(options.bucket_size), lattice_{shapes.box(), octree_levels}, nodes_(1) {
    nodes_[0].facets.assign(shapes.placed().begin(), shapes.placed().end());
    divide(0, {}, 0);
  }

  [[nodiscard]] SpaceBuilt built() const override {
    SpaceBuilt built = built_;
    built.operations = count_.done();
    built.directory_words = nodes_.size();
    count_buckets(
        nodes_, bucket_size_, [](const Node& node) { return node.first == 0; }, built);
    return built;
  }

  [[nodiscard]] std::vector<SpacePart> parts() const override {
    std::vector<SpacePart> parts;
    add_parts_of(nodes_[0], {}, 0, parts);
    return parts;
  }

  template <class Count>
  void walk_cells(const SpaceRay& ray, CellVisitor& visitor, Count& count) const {
    const auto locate = [&](const glm::uvec3& at, Count& counted) {
      const Node* node = nodes_.data();
      unsigned level = 0;
      for (; node->first != 0; ++level) {
        node = &nodes_[node->first + octant_of(at, level)];
        counted(Operation::load_long, 2);
        counted(Operation::logic_long, 3);
        counted(Operation::add_long, 3);
        counted(Operation::branch_taken, 4);
      }
      return Located{node->facets, glm::uvec3{level}};
    };
    PointWalk(lattice_, ray, locate, count).walk_cells(visitor);
  }

 private:
  struct Node {
    std::uint32_t first = 0;  ///< index of the first of eight children; 0 for a cell
    std::vector<std::uint32_t> facets;
  };

  static std::uint32_t octant_of(const glm::uvec3& at, unsigned level) {
    const unsigned bit = octree_levels - 1 - level;
    return (at.x >> bit & 1U) + 2 * (at.y >> bit & 1U) + 4 * (at.z >> bit & 1U);
  }

  void add_parts_of(const Node& node, const glm::uvec3& at, unsigned level, std::vector<SpacePart>& parts) const {
    if (node.first == 0) {
      parts.push_back({.box = lattice_.block(at, glm::uvec3{level}), .facets = node.facets});
      return;
    }
    add_half_of(node.first, 2, at, glm::uvec3{level}, parts);
  }

  /// Adds the parts of the 2^(axis + 1) children that start at index `first`: halves along `axis`, each divided along
  /// the axes before it. Together they fill the block at `at` that results from depths[i] halvings along each axis i.
  void add_half_of(std::uint32_t first, int axis, const glm::uvec3& at, const glm::uvec3& depths,
                   std::vector<SpacePart>& parts) const {
    if (axis < 0) {
      add_parts_of(nodes_[first], at, depths.x, parts);
      return;
    }
    const std::uint32_t size = 1U << (octree_levels - 1 - depths[axis]);
    const std::size_t number = parts.size();
    parts.push_back({lattice_.block(at, depths), axis, lattice_.wall(axis, at[axis] + size)});
    glm::uvec3 halved = depths;
    ++halved[axis];
    parts[number].low = static_cast<std::uint32_t>(parts.size());
    add_half_of(first, axis - 1, at, halved, parts);
    parts[number].high = static_cast<std::uint32_t>(parts.size());
    glm::uvec3 above = at;
    above[axis] += size;
    add_half_of(first + (1U << static_cast<unsigned>(axis)), axis - 1, above, halved, parts);
  }

  void divide(std::uint32_t number, const glm::uvec3& at, unsigned level) {
    if (level == octree_levels || nodes_[number].facets.size() <= bucket_size_) return;
    ++built_.splits;
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    const std::vector<std::uint32_t> facets = std::exchange(nodes_[number].facets, {});
    nodes_[number].first = first;
    nodes_.resize(nodes_.size() + 8);
    const std::uint32_t size = 1U << (octree_levels - 1 - level);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const glm::uvec3 corner = at + size * glm::uvec3{octant & 1U, octant >> 1U & 1U, octant >> 2U};
      const facet::Box box = lattice_.block(corner, glm::uvec3{level + 1});
      built_.overlap_tests += facets.size();
      for (const std::uint32_t facet : facets) {
        if (!shapes_.touches(facet, box, count_)) continue;
        nodes_[first + octant].facets.push_back(facet);
        count_(Operation::load_long);
        count_(Operation::store_long);
      }
      divide(first + octant, corner, level + 1);
    }
  }

  const FacetShapes& shapes_;
  std::uint32_t bucket_size_;
  Lattice lattice_;
  std::vector<Node> nodes_;
  SpaceBuilt built_;
  Counting count_;
};

}  // namespace

extern const DirectoryRow octree_row{"octree", "cells divided into eight, located from the root for each query point",
                                     "Glassner 1984", make_directory<Octree>, true};

}  // namespace csgsim::software
