#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "sim/software/space/clip_ray.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

namespace {

constexpr double max_cells = 128;  ///< per axis

/// Cells of equal size, as cubic as integer numbers of cells allow; about four times the number of facets divided by
/// the bucket size. Rays step from cell to cell by additions (Fujimoto et al. 1986, in the form of Amanatides and
/// Woo 1987).
class Grid final : public DirectoryOf<Grid> {
 public:
  Grid(const FacetShapes& shapes, const SpaceOptions& options) : shapes_(shapes), box_(shapes.box()) {
    if (shapes.placed().empty()) return;
    constexpr double density = 4;
    const glm::dvec3 size = box_.high - box_.low;
    const double cells =
        std::max(1.0, density * static_cast<double>(shapes.placed().size()) / static_cast<double>(options.bucket_size));
    const double edge = std::cbrt(size.x * size.y * size.z / cells);
    for (int axis = 0; axis < 3; ++axis)
      cells_[axis] = static_cast<std::int32_t>(std::clamp(std::round(size[axis] / edge), 1.0, max_cells));
    facets_.resize(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) *
                   static_cast<std::size_t>(cells_.z));
    for (const std::uint32_t facet : shapes.placed()) add_facet(facet);
  }

  [[nodiscard]] SpaceBuilt built() const override {
    SpaceBuilt built = built_;
    built.cells = built.entries = facets_.size();
    built.directory_words = facets_.size();
    for (const std::vector<std::uint32_t>& cell : facets_) {
      built.references += cell.size();
      built.most_facets = std::max<std::uint64_t>(built.most_facets, cell.size());
    }
    built.bucket_words = built.references + built.cells;
    built.operations = count_.done();
    return built;
  }

  template <class Count>
  void walk_cells(const SpaceRay& ray, CellVisitor& visitor, Count& count) const {
    if (facets_.empty()) return;
    const glm::dvec3 inverse = inverse_direction(ray, count);
    const RayPart part = clip_to_box(ray, inverse, box_, count);
    if (part.empty()) return;
    Steps steps = begun(ray, inverse, part, count);
    for (double t = part.begin;;) {
      const int axis = steps.next.x <= steps.next.y ? (steps.next.x <= steps.next.z ? 0 : 2)
                                                    : (steps.next.y <= steps.next.z ? 1 : 2);
      const double exit = std::max(t, std::min(steps.next[axis], part.end));
      count_step(count);
      if (!visitor.visit({t, exit, exit, facets_[index_of(steps.at)]}) || steps.next[axis] >= part.end) return;
      t = exit;
      steps.at[axis] += steps.by[axis];
      if (steps.at[axis] < 0 || steps.at[axis] >= cells_[axis]) return;
      steps.next[axis] += steps.add[axis];
    }
  }

 private:
  struct Steps {
    glm::ivec3 at{0};
    glm::ivec3 by{0};
    glm::dvec3 next{0};  ///< t at the next wall of each axis
    glm::dvec3 add{0};
  };

  [[nodiscard]] std::size_t index_of(const glm::ivec3& at) const {
    return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(cells_.y) + static_cast<std::size_t>(at.y)) *
               static_cast<std::size_t>(cells_.x) +
           static_cast<std::size_t>(at.x);
  }
  [[nodiscard]] double wall(int axis, std::int32_t cell) const {
    if (cell == cells_[axis]) return box_.high[axis];
    return box_.low[axis] + (box_.high[axis] - box_.low[axis]) * cell / cells_[axis];
  }
  [[nodiscard]] std::int32_t cell(int axis, double at) const {
    const double cells = (at - box_.low[axis]) / (box_.high[axis] - box_.low[axis]) * cells_[axis];
    return static_cast<std::int32_t>(std::clamp(std::floor(cells), 0.0, static_cast<double>(cells_[axis] - 1)));
  }

  void add_facet(std::uint32_t facet) {
    const facet::Box& around = shapes_.box_of(facet);
    glm::ivec3 first;
    glm::ivec3 last;
    for (int axis = 0; axis < 3; ++axis) {
      first[axis] = cell(axis, around.low[axis]);
      last[axis] = cell(axis, around.high[axis]);
    }
    for (std::int32_t z = first.z; z <= last.z; ++z) {
      for (std::int32_t y = first.y; y <= last.y; ++y) {
        for (std::int32_t x = first.x; x <= last.x; ++x) add_facet_at({x, y, z}, facet);
      }
    }
  }

  void add_facet_at(const glm::ivec3& at, std::uint32_t facet) {
    facet::Box one;
    for (int axis = 0; axis < 3; ++axis) {
      one.low[axis] = wall(axis, at[axis]);
      one.high[axis] = wall(axis, at[axis] + 1);
    }
    ++built_.overlap_tests;
    if (!shapes_.touches(facet, one, count_)) return;
    facets_[index_of(at)].push_back(facet);
    count_(Operation::store_long, 2);
  }

  /// The first cell, and t at the next wall of each axis.
  template <class Count>
  Steps begun(const SpaceRay& ray, const glm::dvec3& inverse, const RayPart& part, Count& count) const {
    Steps steps;
    const glm::dvec3 point = ray.at(part.begin);
    for (int axis = 0; axis < 3; ++axis) {
      steps.at[axis] = cell(axis, point[axis]);
      const double direction = ray.direction[axis];
      count_products(count, 4);
      count_comparisons(count, 2);
      steps.next[axis] = steps.add[axis] = std::numeric_limits<double>::infinity();
      if (direction == 0) continue;
      steps.by[axis] = direction > 0 ? 1 : -1;
      const double width = (box_.high[axis] - box_.low[axis]) / cells_[axis];
      steps.add[axis] = width * std::abs(inverse[axis]);
      steps.next[axis] = (wall(axis, steps.at[axis] + (direction > 0 ? 1 : 0)) - ray.origin[axis]) * inverse[axis];
    }
    return steps;
  }

  /// Counts a step: the minimum of three values, the cell's facets, and the update along one axis.
  template <class Count>
  static void count_step(Count& count) {
    count_comparisons(count, 3);
    count(Operation::add_long, 3);
    count(Operation::load_long, 3);
    count(Operation::compare);
    count(Operation::branch_taken);
    count(Operation::call);
    count(Operation::come_back);
  }

  const FacetShapes& shapes_;
  facet::Box box_;
  glm::ivec3 cells_{0};
  std::vector<std::vector<std::uint32_t>> facets_;
  SpaceBuilt built_;
  Counting count_;
};

}  // namespace

extern const DirectoryRow grid_row{"grid", "cells of equal size, with steps from cell to cell by additions",
                                   "Fujimoto et al. 1986; Amanatides and Woo 1987", make_directory<Grid>};

}  // namespace csgsim::software
