#include "host/convex/extent.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "host/convex/clip.h"
#include "host/convex/outside.h"
#include "host/convex/polytope.h"
#include "host/convex/solid_products.h"
#include "hw/base/error.h"

namespace csgsim::convex {

namespace {

facet::Box moved(const facet::Box& box, const glm::dvec3& by) {
  return box.empty() ? box : facet::Box{box.low + by, box.high + by};
}

constexpr std::string_view searching = "searching for the extent";

/// A convex part of a product, and the primitives not yet subtracted from it. The last one is subtracted next.
struct Rest {
  Polytope polytope;
  std::vector<std::uint32_t> subtracted;
};

/// Searches for the box of all parts. Boxes are relative to PlaneTable::centre().
class BoxSearch {
 public:
  BoxSearch(const facet::Geometry& geometry, std::size_t max_cuts, const Work& work)
      : geometry_(geometry), max_cuts_(max_cuts), work_(work) {
    for (const facet::Convex& solid : geometry.solids) boxes_.push_back(moved(solid.box, -geometry.planes.centre()));
  }

  void add(SolidProduct product) {
    Rest part{std::move(product.whole), std::move(product.subtracted)};
    find_corners(part);
    if (!is_found(part)) open_.push_back(std::move(part));
  }

  /// The box of all parts added.
  facet::Box find() {
    while (!open_.empty()) {
      const Rest part = std::move(open_.back());
      open_.pop_back();
      if (is_found(part)) continue;
      if (part.subtracted.empty() || cuts_ >= max_cuts_) {
        found_ = hull(found_, box_of(part.polytope));
      } else {
        cut(part);
      }
    }
    return found_;
  }

 private:
  [[nodiscard]] bool is_found(const Rest& part) const { return hull(found_, box_of(part.polytope)) == found_; }

  /// Adds corners that no subtracted primitive touches: they are corners of the model.
  void find_corners(const Rest& part) {
    for (const glm::dvec3& corner : part.polytope.vertices) {
      const facet::Box more = hull(found_, corner);
      if (more == found_) continue;
      work_.charge(part.subtracted.size(), searching);
      const bool stays = std::none_of(part.subtracted.begin(), part.subtracted.end(),
                                      [&](std::uint32_t primitive) { return touches(primitive, corner); });
      if (stays) found_ = more;
    }
  }

  [[nodiscard]] bool touches(std::uint32_t primitive, const glm::dvec3& point) const {
    const std::vector<facet::Halfspace>& halfspaces = geometry_.solids[primitive].halfspaces;
    work_.charge(halfspaces.size(), searching);
    return std::all_of(halfspaces.begin(), halfspaces.end(), [&](facet::Halfspace halfspace) {
      return outward_plane(halfspace, geometry_.planes).height(point) <= tolerance(geometry_.planes);
    });
  }

  void cut(const Rest& part) {
    ++cuts_;
    const std::uint32_t taken = part.subtracted.back();
    for (Polytope& polytope : outside(part.polytope, geometry_.solids[taken], geometry_.planes, work_)) {
      work_.charge(polytope.vertices.size() + part.subtracted.size(), searching);
      const facet::Box box = box_of(polytope);
      Rest rest{std::move(polytope), {}};
      std::copy_if(part.subtracted.begin(), std::prev(part.subtracted.end()), std::back_inserter(rest.subtracted),
                   [&](std::uint32_t primitive) { return !common(boxes_[primitive], box).empty(); });
      find_corners(rest);
      if (!is_found(rest)) open_.push_back(std::move(rest));
    }
  }

  const facet::Geometry& geometry_;
  std::size_t max_cuts_;
  const Work& work_;
  std::size_t cuts_ = 0;
  std::vector<facet::Box> boxes_;  ///< boxes of the primitives
  std::vector<Rest> open_;
  facet::Box found_;
};

/// Whether the tree contains only unions of primitives, so that the primitives' boxes give the box of the model.
bool is_union(const csg::PositiveTree& tree) {
  return std::all_of(tree.nodes.begin(), tree.nodes.end(), [](const csg::PositiveNode& node) {
    return node.is_leaf ? !node.complemented : node.op == csg::PositiveOperator::unite;
  });
}

/// Location of the neighbourhood of a point relative to a solid: entirely outside, undecided, or entirely inside.
enum class Known : std::uint8_t { out, maybe, in };

/// Tests whether corners of primitives are corners of the model. Points are relative to PlaneTable::centre().
class CornerSearch {
 public:
  CornerSearch(const facet::Geometry& geometry, const csg::PositiveTree& tree)
      : geometry_(geometry), tree_(tree), known_(tree.nodes.size()) {}

  /// Whether each side of geometry.box contains a corner of the model.
  bool reach_all_sides() {
    for (int axis = 0; axis < 3; ++axis) {
      if (!reach(axis, -1.0, geometry_.box.low[axis]) || !reach(axis, 1.0, geometry_.box.high[axis])) return false;
    }
    return true;
  }

 private:
  /// Maximum number of corners tested per side; after these the side is undecided. If a flush cut leaves many corners
  /// undecided, more tests rarely help.
  static constexpr int max_tested_corners = 64;

  bool reach(int axis, double sign, double side) {
    int visited = 0;
    for (std::uint32_t i = 0; i < geometry_.solids.size(); ++i) {
      const facet::Box& box = geometry_.solids[i].box;
      const double farthest = sign > 0.0 ? box.high[axis] : box.low[axis];
      const bool is_short = box.empty() || sign * farthest < sign * side - tolerance(geometry_.planes);
      if (is_short || tree_.nodes[tree_.leaf_of[i]].complemented) continue;
      for (const glm::dvec3& corner : geometry_.solids[i].vertices) {
        if (sign * corner[axis] < sign * side - tolerance(geometry_.planes)) continue;
        if (is_corner(i, corner - geometry_.planes.centre())) return true;
        if (++visited == max_tested_corners) return false;
      }
    }
    return false;
  }

  /// Whether a primitive's corner is a corner of the model. Near the corner the primitive is both inside and outside;
  /// what is known about other primitives holds all around it. If the tree is inside wherever the primitive is, the
  /// corner is on the model.
  bool is_corner(std::uint32_t primitive, const glm::dvec3& corner) {
    if (primitive_at(primitive, corner) == Known::out) return false;
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
      const csg::PositiveNode& node = tree_.nodes[i];
      if (node.is_leaf) {
        const Known in = node.primitive == primitive ? Known::in : primitive_at(node.primitive, corner);
        known_[i] = node.complemented ? complement(in) : in;
        continue;
      }
      const bool unites = node.op == csg::PositiveOperator::unite;
      known_[i] = unites ? Known::out : Known::in;
      for (const std::uint32_t child : node.children)
        known_[i] = unites ? std::max(known_[i], known_[child]) : std::min(known_[i], known_[child]);
    }
    return known_[tree_.root] == Known::in;
  }

  static Known complement(Known known) {
    return known == Known::in ? Known::out : known == Known::out ? Known::in : Known::maybe;
  }

  [[nodiscard]] Known primitive_at(std::uint32_t primitive, const glm::dvec3& point) const {
    const double near = tolerance(geometry_.planes);
    const facet::Convex& solid = geometry_.solids[primitive];
    const glm::dvec3 place = point + geometry_.planes.centre();
    if (solid.box.empty() || glm::any(glm::lessThan(place, solid.box.low - near)) ||
        glm::any(glm::greaterThan(place, solid.box.high + near)))
      return Known::out;
    Known known = Known::in;
    for (const facet::Halfspace halfspace : solid.halfspaces) {
      const double height = outward_plane(halfspace, geometry_.planes).height(point);
      if (height > near) return Known::out;
      if (height > -near) known = Known::maybe;
    }
    return known;
  }

  const facet::Geometry& geometry_;
  const csg::PositiveTree& tree_;
  std::vector<Known> known_;  ///< what is known about each node
};

facet::Box searched(const facet::Geometry& geometry, const csg::PositiveTree& tree, std::size_t max_cuts,
                    std::uint64_t max_steps) {
  const Work work(max_steps);
  BoxSearch search(geometry, max_cuts, work);
  try {
    for_each_product(
        geometry, tree, [&](SolidProduct product) { search.add(std::move(product)); }, max_cuts, work);
    return moved(search.find(), geometry.planes.centre());
  } catch (const InputError&) {
    return geometry.box;  // the number of choices or steps reached its limit
  }
}

}  // namespace

facet::Box extent(const facet::Geometry& geometry, const csg::PositiveTree& tree, std::size_t max_cuts,
                  std::uint64_t max_steps) {
  if (geometry.box.empty() || is_union(tree) || CornerSearch(geometry, tree).reach_all_sides()) return geometry.box;
  const facet::Box found = common(geometry.box, searched(geometry, tree, max_cuts, max_steps));
  if (found.empty()) return geometry.box;
  const double near = tolerance(geometry.planes);
  facet::Box box = geometry.box;
  for (int axis = 0; axis < 3; ++axis) {
    if (found.low[axis] > box.low[axis] + near) box.low[axis] = found.low[axis];
    if (found.high[axis] < box.high[axis] - near) box.high[axis] = found.high[axis];
  }
  return box;
}

}  // namespace csgsim::convex
