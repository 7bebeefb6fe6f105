#include "tests/unit/software/recount_space.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace csgsim::testing {

namespace {

using enum processors::Operation;

using software::Directory;
using software::FacetShapes;
using software::SpaceBox;
using software::SpaceBuilt;
using software::SpacePart;
using software::SpaceRay;
using Numbers3 = std::array<std::uint32_t, 3>;
using List = std::vector<std::uint32_t>;

constexpr double infinite = std::numeric_limits<double>::infinity();

const Operations kept = steps({load_long, store_long});

/// Counts the operations of building a directory.
class Builder {
 public:
  Builder(const FacetShapes& shapes, std::uint32_t bucket_size) : shapes_(shapes), bucket_size_(bucket_size) {}

  SpaceBuilt built() {
    built_.operations = sum_;
    return built_;
  }

 protected:
  void charge(const Operations& operations) { sum_ += operations; }

  /// Whether a facet is within reach of a box. Axes are tried until one separates them: the box's own, the facet's
  /// normal, and the cross products of each edge and an axis.
  bool touches(std::uint32_t facet, const facet::Box& box) {
    charge(calls(1));
    charge(comparisons(6));
    ++built_.overlap_tests;
    const facet::Box& around = shapes_.box_of(facet);
    for (int axis = 0; axis < 3; ++axis) {
      if (box.low[axis] > around.high[axis] || around.low[axis] > box.high[axis]) return false;
    }
    const auto corners = shapes_.facets().corners_of(facet);
    const glm::dvec3 middle = (box.low + box.high) / 2.0;
    const glm::dvec3 half = (box.high - box.low) / 2.0 + shapes_.reach();
    const auto is_apart = [&](const glm::dvec3& along) {
      double low = infinite;
      double high = -infinite;
      for (const glm::dvec3& corner : corners) {
        low = std::min(low, glm::dot(along, corner - middle));
        high = std::max(high, glm::dot(along, corner - middle));
      }
      const double reach = glm::dot(glm::abs(along), half);
      return low > reach || high < -reach;
    };
    if (corners.size() == 1) return true;
    if (corners.size() == 2) {
      charge(products(12));
      for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 unit{0};
        unit[axis] = 1;
        if (is_apart(glm::cross(unit, corners[1] - corners[0]))) return false;
      }
      return true;
    }
    glm::dvec3 normal{0};
    for (std::size_t i = 2; i < corners.size(); ++i)
      normal += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    normal = glm::length(normal) > 0 ? normal / glm::length(normal) : glm::dvec3{0};
    charge(products(3 * corners.size() + 3));
    charge(comparisons(2));
    if (is_apart(normal)) return false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        charge(products(4));
        charge(comparisons(1));
        if (std::abs(normal[axis]) < 1e-6) continue;  // edge-on
        glm::dvec3 unit{0};
        unit[axis] = normal[axis] > 0 ? 1 : -1;
        const glm::dvec3 out = glm::cross(corners[(i + 1) % corners.size()] - corners[i], unit);
        const glm::dvec3 size = glm::abs(out);
        if (size.x + size.y + size.z < 1e-6 * glm::length(shapes_.box().high - shapes_.box().low)) continue;
        if (glm::dot(out, middle - corners[i]) > glm::dot(size, half)) return false;
      }
    }
    return true;
  }

  void add_cell(std::size_t facets) {
    ++built_.cells;
    built_.references += facets;
    built_.most_facets = std::max<std::uint64_t>(built_.most_facets, facets);
  }

  /// A block of a lattice of 2^bits cells along each axis, from the first numbers up to the last.
  [[nodiscard]] facet::Box block(const Numbers3& first, const Numbers3& end, unsigned bits) const {
    facet::Box box;
    const double cells = std::ldexp(1.0, static_cast<int>(bits));
    const auto wall = [&](int axis, std::uint32_t number) {
      const double low = shapes_.box().low[axis];
      const double high = shapes_.box().high[axis];
      return number == static_cast<std::uint32_t>(cells) ? high : low + (high - low) * (number / cells);
    };
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = wall(axis, first[static_cast<std::size_t>(axis)]);
      box.high[axis] = wall(axis, end[static_cast<std::size_t>(axis)]);
    }
    return box;
  }

  const FacetShapes& shapes_;
  std::uint32_t bucket_size_;
  SpaceBuilt built_;
  Operations sum_;
};

/// Inserts facets one by one; halves a full cell, and doubles the directory if it has no entry for a half.
class ExcellBuilder : public Builder {
 public:
  using Builder::Builder;

  SpaceBuilt run() {
    if (shapes_.placed().size() >= 4096) throw std::logic_error("the recount does not support a second directory");
    for (const std::uint32_t facet : shapes_.placed()) insert(root_, facet);
    built_.entries = std::uint64_t{1} << level_;
    built_.directory_words = 4 + built_.entries;
    add_cells(root_);
    return built();
  }

 private:
  static constexpr unsigned last = 15;
  struct Cell {
    Numbers3 first{0, 0, 0};
    Numbers3 end{32, 32, 32};
    unsigned level = 0;
    List facets{};
    std::vector<Cell> halves{};
  };

  [[nodiscard]] std::uint64_t buckets(const Cell& cell) const {
    return (cell.facets.size() + bucket_size_ - 1) / bucket_size_;
  }

  void insert(Cell& cell, std::uint32_t facet) {
    if (!touches(facet, block(cell.first, cell.end, 5))) return;
    // The entry of the range is read, and its bucket's level is compared with the range's.
    charge(steps({shift_long, shifted_bit, add_long, load_long, load, compare, branch}));
    if (cell.halves.empty()) {
      charge(steps({{load_long, buckets(cell)}}));
      charge(steps({{load, 2}, {compare, 2}, {branch, 2}}));
      if (cell.facets.size() < bucket_size_ || cell.level == last) {
        charge(steps({store_long}));
        cell.facets.push_back(facet);
        return;
      }
      halve(cell);
    }
    for (Cell& half : cell.halves) insert(half, facet);
  }

  void halve(Cell& cell) {
    ++built_.splits;
    if (cell.level == level_) {
      const std::uint64_t entries = std::uint64_t{1} << level_++;
      charge(entries * steps({load_long, {store_long, 2}, branch_taken}));
    }
    charge(steps({{store_long, 4 + (std::uint64_t{1} << (level_ - cell.level - 1))}}));
    const std::size_t axis = cell.level % 3;
    Cell low{cell.first, cell.end, cell.level + 1};
    low.end[axis] = (cell.first[axis] + cell.end[axis]) / 2;
    Cell high{cell.first, cell.end, cell.level + 1};
    high.first[axis] = low.end[axis];
    for (const std::uint32_t facet : cell.facets) {
      charge(kept);
      for (Cell* const half : {&low, &high}) {
        if (touches(facet, block(half->first, half->end, 5))) half->facets.push_back(facet);
      }
    }
    cell.facets.clear();
    cell.halves = {std::move(low), std::move(high)};
  }

  void add_cells(const Cell& cell) {
    for (const Cell& half : cell.halves) add_cells(half);
    if (!cell.halves.empty()) return;
    add_cell(cell.facets.size());
    const std::uint64_t chained = std::max<std::uint64_t>(1, buckets(cell));
    built_.overflows += chained > 1 ? 1U : 0U;
    built_.bucket_words += chained * (2 + bucket_size_);
  }

  Cell root_;
  unsigned level_ = 0;  ///< level of the directory, which has 2^level entries
};

/// Cuts full cells into eight, up to seven levels.
class OctreeBuilder : public Builder {
 public:
  using Builder::Builder;

  SpaceBuilt run() {
    cut({0, 0, 0}, 128, {shapes_.placed().begin(), shapes_.placed().end()});
    built_.directory_words = built_.entries;
    built_.bucket_words = built_.references + built_.cells;
    return built();
  }

 private:
  void cut(const Numbers3& first, std::uint32_t size, const List& facets) {
    ++built_.entries;
    if (size == 1 || facets.size() <= bucket_size_) {
      add_cell(facets.size());
      built_.overflows += facets.size() > bucket_size_ ? 1U : 0U;
      return;
    }
    ++built_.splits;
    const std::uint32_t half = size / 2;
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const Numbers3 at{first[0] + (octant & 1U) * half, first[1] + (octant / 2 & 1U) * half,
                        first[2] + octant / 4 * half};
      List own;
      for (const std::uint32_t facet : facets) {
        if (!touches(facet, block(at, {at[0] + half, at[1] + half, at[2] + half}, 7))) continue;
        own.push_back(facet);
        charge(kept);
      }
      cut(at, half, own);
    }
  }
};

/// Halves a full cell by the cheapest of 31 walls per axis if that is cheaper than the cell.
class KdBuilder : public Builder {
 public:
  KdBuilder(const FacetShapes& shapes, std::uint32_t bucket_size, const Directory& made)
      : Builder(shapes, bucket_size), parts_(made.parts()) {}

  SpaceBuilt run() {
    const std::size_t facets = shapes_.placed().size();
    halve(parts_[0], {shapes_.placed().begin(), shapes_.placed().end()},
          static_cast<unsigned>(8 + 1.3 * static_cast<double>(std::bit_width(facets))));
    built_.entries = parts_.size();
    built_.directory_words = 2 * parts_.size();
    built_.bucket_words = built_.references + built_.cells;
    return built();
  }

 private:
  void halve(const SpacePart& part, const List& facets, unsigned levels) {
    const std::uint64_t size = facets.size();
    if (levels > 0 && size > bucket_size_) {
      // A facet has one of 32 places along an axis; a wall's cost is computed from two surfaces.
      charge(3 * quotients(2 * size));
      charge(3 * steps({{load_long, 4 * size}, {store_long, 2 * size}}));
      charge(3 * products(6 * 32));
    }
    if (part.is_cell()) {
      if (!std::ranges::equal(part.facets, facets)) throw std::logic_error("a cell has unexpected facets");
      add_cell(size);
      built_.overflows += size > bucket_size_ ? 1U : 0U;
      return;
    }
    ++built_.splits;
    std::array<List, 2> halves;
    const std::array both{&parts_[part.low], &parts_[part.high]};
    for (const std::uint32_t facet : facets) {
      charge(kept);
      for (std::size_t half = 0; half < 2; ++half) {
        if (touches(facet, both[half]->box)) halves[half].push_back(facet);
      }
    }
    for (std::size_t half = 0; half < 2; ++half) halve(*both[half], halves[half], levels - 1);
  }

  std::vector<SpacePart> parts_;
};

/// Tests a facet against all cells of uniform size that its box overlaps.
class GridBuilder : public Builder {
 public:
  using Builder::Builder;

  SpaceBuilt run() {
    if (shapes_.placed().empty()) return built();
    const facet::Box& box = shapes_.box();
    const glm::dvec3 size = box.high - box.low;
    const double wanted = std::max(1.0, 4.0 * static_cast<double>(shapes_.placed().size()) / bucket_size_);
    const double edge = std::cbrt(size.x * size.y * size.z / wanted);
    glm::dvec3 cells{0};
    for (int axis = 0; axis < 3; ++axis) cells[axis] = std::clamp(std::round(size[axis] / edge), 1.0, 128.0);
    const auto wall = [&](int axis, int cell) {
      return cell == cells[axis] ? box.high[axis] : box.low[axis] + size[axis] * cell / cells[axis];
    };
    const auto cell = [&](int axis, double at) {
      return static_cast<int>(
          std::clamp(std::floor((at - box.low[axis]) / size[axis] * cells[axis]), 0.0, cells[axis] - 1));
    };
    std::map<std::array<int, 3>, std::size_t> facets;
    for (const std::uint32_t facet : shapes_.placed()) {
      const facet::Box& around = shapes_.box_of(facet);
      for (int x = cell(0, around.low.x); x <= cell(0, around.high.x); ++x) {
        for (int y = cell(1, around.low.y); y <= cell(1, around.high.y); ++y) {
          for (int z = cell(2, around.low.z); z <= cell(2, around.high.z); ++z) {
            const facet::Box one{{wall(0, x), wall(1, y), wall(2, z)},
                                 {wall(0, x + 1), wall(1, y + 1), wall(2, z + 1)}};
            if (!touches(facet, one)) continue;
            ++facets[{x, y, z}];
            charge(steps({{store_long, 2}}));
          }
        }
      }
    }
    for (const auto& [at, number] : facets) add_cell(number);
    built_.cells = built_.entries = built_.directory_words = static_cast<std::uint64_t>(cells.x * cells.y * cells.z);
    built_.bucket_words = built_.references + built_.cells;
    return built();
  }
};

/// Trees of boxes, taken from the directory.
class BoxesBuilder : public Builder {
 public:
  BoxesBuilder(const FacetShapes& shapes, std::uint32_t bucket_size, const Directory& made)
      : Builder(shapes, bucket_size), boxes_(made.boxes()) {}

  /// Boxes are divided by the surface heuristic with 16 bins along each axis where middles differ.
  SpaceBuilt run_heuristic() {
    for (const SpaceBox& box : boxes_) {
      const List facets = below(box);
      built_.splits += box.low != 0 ? 1U : 0U;
      built_.overflows += box.low == 0 && facets.size() > bucket_size_ ? 1U : 0U;
      if (facets.size() <= bucket_size_) continue;
      for (int axis = 0; axis < 3; ++axis) {
        std::set<double> middles;
        for (const std::uint32_t facet : facets) middles.insert(shapes_.box_of(facet).centre()[axis]);
        if (middles.size() < 2) continue;
        charge(quotients(facets.size()));
        charge(comparisons(6 * facets.size()));
        charge(products(8 * 16));
      }
    }
    return counted();
  }

  /// Primitives are halved at the middle one, and a primitive's facets likewise once a ray has entered its box.
  SpaceBuilt run_primitives() {
    charge(comparisons(6 * shapes_.placed().size()));
    for (const SpaceBox& box : boxes_) {
      const List facets = below(box);
      if (facets.empty()) continue;
      std::set<std::uint32_t> primitives;
      for (const std::uint32_t facet : facets) primitives.insert(shapes_.facets().facets[facet].primitive);
      const bool is_whole = primitives.size() > 1 || facets.size() == placed_of(*primitives.begin());
      if (is_whole) divide(primitives.size());
      // An expanded primitive is divided again, into its facets.
      const bool is_expanded = primitives.size() == 1 && box.low != 0;
      if (is_expanded || !is_whole) divide(facets.size());
    }
    return counted();
  }

 private:
  void divide(std::uint64_t groups) {
    charge(comparisons(6 * groups));
    if (groups == 1) return;
    charge(comparisons(3 * groups));
    ++built_.splits;
  }

  [[nodiscard]] List below(const SpaceBox& box) const {
    if (box.low == 0) return {box.facets.begin(), box.facets.end()};
    List facets = below(boxes_[box.low]);
    const List others = below(boxes_[box.low + 1]);
    facets.insert(facets.end(), others.begin(), others.end());
    return facets;
  }

  [[nodiscard]] std::size_t placed_of(std::uint32_t primitive) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        shapes_.placed(), [&](std::uint32_t facet) { return shapes_.facets().facets[facet].primitive == primitive; }));
  }

  SpaceBuilt counted() {
    for (const SpaceBox& box : boxes_) {
      if (box.low == 0) add_cell(box.facets.size());
    }
    built_.entries = boxes_.size();
    built_.directory_words = 8 * boxes_.size();
    built_.bucket_words = shapes_.placed().size();
    return built();
  }

  std::vector<SpaceBox> boxes_;
};

}  // namespace

SpaceBuilt recounted_space(const std::string& name, const FacetShapes& shapes, std::uint32_t bucket_size,
                           const Directory& made) {
  if (name == "excell" || name == "excell-recursive") return ExcellBuilder(shapes, bucket_size).run();
  if (name == "octree") return OctreeBuilder(shapes, bucket_size).run();
  if (name == "kd-tree") return KdBuilder(shapes, bucket_size, made).run();
  if (name == "grid") return GridBuilder(shapes, bucket_size).run();
  if (name == "bvh") return BoxesBuilder(shapes, bucket_size, made).run_heuristic();
  if (name == "boxes") return BoxesBuilder(shapes, bucket_size, made).run_primitives();
  if (name != "none") throw std::invalid_argument(name);
  SpaceBuilt built;
  built.cells = 1;
  built.references = built.most_facets = built.bucket_words = shapes.placed().size();
  return built;
}

/// State of a ray during its walk.
struct WalkRecount::Walk {
  const SpaceRay& ray;
  std::size_t left;  ///< remaining cells to visit
  bool is_stopped;
  Operations sum{};

  [[nodiscard]] bool is_over() const { return left == 0 && is_stopped; }
  void visit() {
    if (left == 0) throw std::logic_error("a ray visited fewer cells than it passes through");
    --left;
    sum += calls(1);
  }

  /// The part of the ray in a box, axis by axis, until nothing is left.
  bool clip(const facet::Box& box, double& begin, double& end) {
    begin = ray.begin;
    end = ray.end;
    for (int axis = 0; axis < 3; ++axis) {
      if (begin > end) return false;
      sum += steps({{load_long, 3}, branch});
      if (ray.direction[axis] == 0) {
        sum += comparisons(2);
        if (ray.origin[axis] < box.low[axis] || ray.origin[axis] > box.high[axis]) return false;
        continue;
      }
      sum += steps({{add_long, 2}});
      sum += products(2);
      sum += comparisons(3);
      const double one = at(axis, box.low[axis]);
      const double other = at(axis, box.high[axis]);
      begin = std::max(begin, std::min(one, other));
      end = std::min(end, std::max(one, other));
    }
    return begin <= end;
  }

  /// Position of the ray at a wall.
  [[nodiscard]] double at(int axis, double wall) const {
    return (wall - ray.origin[axis]) * (1.0 / ray.direction[axis]);
  }
};

WalkRecount::WalkRecount(const std::string& name, const FacetShapes& shapes, std::uint32_t bucket_size,
                         const Directory& made)
    : name_(name),
      box_(shapes.box()),
      bucket_size_(bucket_size),
      halved_(name == "excell-recursive" ? software::directory_of("excell").make(shapes, {bucket_size}) : nullptr),
      parts_(halved_ ? halved_->parts() : made.parts()),
      boxes_(made.boxes()),
      is_empty_(shapes.placed().empty()) {
  if (name_ != "excell" && name_ != "octree") return;
  for (const SpacePart& part : parts_) {
    if (!part.is_cell()) continue;
    Block block{{}, {}, part.facets.size()};
    for (int axis = 0; axis < 3; ++axis) {
      block.first[static_cast<std::size_t>(axis)] = std::llround(number(axis, part.box.low[axis]));
      block.end[static_cast<std::size_t>(axis)] = std::llround(number(axis, part.box.high[axis]));
    }
    blocks_.push_back(block);
  }
}

Operations WalkRecount::along(const SpaceRay& ray, std::size_t cells, bool is_stopped) const {
  Walk walk{ray, cells, is_stopped};
  if (name_ == "none") return {};
  const bool may_be_empty = name_ == "grid" || name_ == "bvh" || name_ == "boxes";
  if (may_be_empty && is_empty_) return {};
  walk.sum += quotients(3);
  if (!boxes_.empty()) {
    go_by_boxes(walk);
    return walk.sum;
  }
  double begin = 0;
  double end = 0;
  if (!walk.clip(box_, begin, end)) return walk.sum;
  if (name_ == "grid") {
    walk.sum += 3 * products(4);
    walk.sum += 3 * comparisons(2);
    for (std::size_t i = 0; i < cells; ++i) {
      walk.visit();
      walk.sum += comparisons(3);
      walk.sum += steps({{add_long, 3}, {load_long, 3}, compare, branch_taken});
    }
  } else if (name_ == "excell" || name_ == "octree") {
    go_by_points(walk, begin, end);
  } else {
    go_by_halves(walk, parts_[0], begin, end);
  }
  if (walk.left != 0) throw std::logic_error("a ray visited more cells than it passes through");
  return walk.sum;
}

/// Visits the nearer half first and the rest of the ray in the other one.
void WalkRecount::go_by_halves(Walk& walk, const SpacePart& part, double begin, double end) const {
  walk.sum += steps({{load_long, 3}});
  if (name_ == "kd-tree") {
    walk.sum += steps({{load_long, 2}, branch});
  } else {
    walk.sum += steps({shift_long, shifted_bit, add_long, load_long, load, compare, branch});
    if (part.is_cell()) {
      walk.sum += steps({{load_long, lists(part.facets.size())}});
    } else {
      // Position of the wall.
      walk.sum += steps({shift_long, shifted_bit, {add_long, 2}});
      walk.sum += products(1);
    }
  }
  if (part.is_cell()) return walk.visit();
  walk.sum += steps({{load_long, 3}, branch});
  const double direction = walk.ray.direction[part.axis];
  if (direction == 0) {
    walk.sum += comparisons(1);
    walk.sum += steps({{store_long, 3}});
    return go_by_halves(walk, parts_[walk.ray.origin[part.axis] < part.wall ? part.low : part.high], begin, end);
  }
  const double t = walk.at(part.axis, part.wall);
  const SpacePart& first = parts_[direction > 0 ? part.low : part.high];
  const SpacePart& second = parts_[direction > 0 ? part.high : part.low];
  const bool goes_through = begin < t && t < end;
  walk.sum += steps({add_long, {store_long, goes_through ? 6U : 3U}});
  walk.sum += products(1);
  walk.sum += comparisons(2);
  if (t >= end) return go_by_halves(walk, first, begin, end);
  if (t <= begin) return go_by_halves(walk, second, begin, end);
  go_by_halves(walk, first, begin, t);
  if (!walk.is_over()) go_by_halves(walk, second, t, end);
}

/// A block of a lattice holds the query point; the next block is behind the nearest of its walls.
void WalkRecount::go_by_points(Walk& walk, double begin, double end) const {
  const auto at_place = [&](int axis, double place) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(number(axis, place))), 0, cells() - 1);
  };
  const auto wall = [&](int axis, std::int64_t number) {
    const double low = box_.low[axis];
    const double high = box_.high[axis];
    return number == cells() ? high : low + (high - low) * (static_cast<double>(number) / static_cast<double>(cells()));
  };
  walk.sum += products(6);
  std::array<std::int64_t, 3> at{};
  double t = begin;
  for (int axis = 0; axis < 3; ++axis) at[static_cast<std::size_t>(axis)] = at_place(axis, walk.ray.at(t)[axis]);
  for (;;) {
    const auto block = std::ranges::find_if(blocks_, [&](const Block& one) { return one.holds(at); });
    if (block == blocks_.end()) throw std::logic_error("no cell contains the query point");
    const auto halvings = [&](std::size_t axis) {
      return std::bit_width(static_cast<std::uint64_t>(block->end[axis] - block->first[axis])) - 1;
    };
    if (name_ == "excell") {
      // Three tables give the address; the entry is read, then the lists of the bucket.
      walk.sum += steps({{load_long, 4 + lists(block->facets)},
                         {logic_long, 3},
                         shift_long,
                         shifted_bit,
                         add_long,
                         branch,
                         {load, 2}});
    } else {
      const auto levels = static_cast<std::uint64_t>(7 - halvings(0));
      walk.sum += levels * steps({{load_long, 2}, {logic_long, 3}, {add_long, 3}, {branch_taken, 4}});
    }
    walk.visit();
    int exit = -1;
    double out = end;
    for (int axis = 0; axis < 3; ++axis) {
      const auto number = static_cast<std::size_t>(axis);
      walk.sum += steps({load_long, branch});
      const double direction = walk.ray.direction[axis];
      if (direction == 0) continue;
      walk.sum += steps({shift_long, {shifted_bit, static_cast<std::uint64_t>(halvings(number))}, {add_long, 2}});
      walk.sum += products(2);
      walk.sum += comparisons(1);
      const double there = walk.at(axis, wall(axis, direction > 0 ? block->end[number] : block->first[number]));
      if (there >= out) continue;
      out = there;
      exit = axis;
    }
    if (walk.is_over() || exit < 0) return;
    walk.sum += products(4);
    walk.sum += steps({{add_long, 4}});
    walk.sum += comparisons(2);
    t = std::max(t, out);
    for (int axis = 0; axis < 3; ++axis) {
      const auto number = static_cast<std::size_t>(axis);
      const std::int64_t first = block->first[number];
      const std::int64_t behind = block->end[number];
      at[number] = std::clamp(at_place(axis, walk.ray.at(t)[axis]), first, behind - 1);
      if (axis == exit) at[number] = walk.ray.direction[axis] > 0 ? behind : first - 1;
      if (at[number] < 0 || at[number] == cells()) return;
    }
  }
}

/// Visits the nearest of all boxes met first; they are in a heap, which takes one step per level.
void WalkRecount::go_by_boxes(Walk& walk) const {
  struct Met {
    double begin;
    std::uint32_t box;
    bool operator>(const Met& other) const { return begin > other.begin; }
  };
  const auto levels = [](std::size_t size) { return static_cast<std::uint64_t>(std::bit_width(size)); };
  std::vector<Met> met;
  const auto meet = [&](std::uint32_t box) {
    double begin = 0;
    double end = 0;
    if (!walk.clip(boxes_[box].box, begin, end)) return;
    met.push_back({begin, box});
    std::ranges::push_heap(met, std::greater{});
    walk.sum += comparisons(levels(met.size()) - 1);
    walk.sum += steps({{store_long, 2}});
  };
  meet(0);
  while (!met.empty()) {
    std::ranges::pop_heap(met, std::greater{});
    const SpaceBox& box = boxes_[met.back().box];
    met.pop_back();
    walk.sum += levels(met.size()) * (comparisons(2) + steps({{store_long, 2}}));
    walk.sum += steps({{load_long, 2}, branch});
    if (box.low != 0) {
      meet(box.low);
      meet(box.low + 1);
      continue;
    }
    walk.visit();
    if (walk.is_over()) return;
  }
}

}  // namespace csgsim::testing
