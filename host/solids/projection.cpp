#include "host/solids/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <polyclipping/clipper.hpp>
#include <span>
#include <utility>
#include <vector>

#include "host/facet/geometry.h"
#include "host/flat/clip_steps.h"
#include "host/flat/hull.h"
#include "host/solids/plan.h"
#include "host/solids/plane_grid.h"

namespace csgsim::solids {

namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

/// OpenSCAD treats corners of solids as equal within this distance, in model units.
constexpr double same_corner = 0x1p-20;

/// Maximum rounding error of a corner's z, as a fraction of the larger of |x| and |y|.
constexpr double corner_rounding = 0x1p-47;

/// Maximum rounding step, as a fraction of an outline's size, without a warning.
constexpr double fine_enough = 1e-6;

bool is_in_plane(const glm::dvec3& corner) {
  return std::abs(corner.z) <=
         std::max(same_corner, corner_rounding * std::max(std::abs(corner.x), std::abs(corner.y)));
}

/// The intersection of an edge with the plane, computed from the end that is closer to the plane.
glm::dvec2 crossing(const glm::dvec3& one, const glm::dvec3& other) {
  if (std::abs(other.z) < std::abs(one.z)) return crossing(other, one);
  return one + (other - one) * (one.z / (one.z - other.z));
}

flat::Outline make_hull(std::vector<glm::dvec2> points) {
  const flat::Area made = flat::hull(std::array{flat::Area{{std::move(points)}}});
  return made.empty() ? flat::Outline{} : made.outlines.front();
}

/// The hull of a convex solid's corners in the x, y plane and of its edges' intersections with the plane.
flat::Outline make_section(const facet::Convex& solid) {
  std::vector<glm::dvec2> points;
  std::vector<bool> is_in;
  for (const glm::dvec3& vertex : solid.vertices) {
    is_in.push_back(is_in_plane(vertex));
    if (is_in.back()) points.emplace_back(vertex);
  }
  for (const auto& [from, to] : solid.edges) {
    const bool crosses = !is_in[from] && !is_in[to] && (solid.vertices[from].z < 0) != (solid.vertices[to].z < 0);
    if (crosses) points.push_back(crossing(solid.vertices[from], solid.vertices[to]));
  }
  return make_hull(std::move(points));
}

facet::Box box_of(const flat::Outline& outline) {
  facet::Box box;
  for (const glm::dvec2& corner : outline) box = facet::hull(box, glm::dvec3(corner, 0));
  return box;
}

/// The part of a convex outline where a coordinate is at least, or at most, the limit.
flat::Outline cut(const flat::Outline& outline, int axis, double limit, bool is_least) {
  const auto is_inside = [&](const glm::dvec2& corner) {
    return is_least ? corner[axis] >= limit : corner[axis] <= limit;
  };
  flat::Outline made;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2& here = outline[i];
    const glm::dvec2& next = outline[i + 1 < outline.size() ? i + 1 : 0];
    if (is_inside(here)) made.push_back(here);
    if (is_inside(here) == is_inside(next)) continue;
    glm::dvec2 between = here + (next - here) * ((limit - here[axis]) / (next[axis] - here[axis]));
    between[axis] = limit;
    made.push_back(between);
  }
  return made;
}

/// The part of a convex outline inside a box enlarged by its size. The rest cannot affect the result in the box.
flat::Outline cut_around(flat::Outline outline, const facet::Box& box) {
  const double margin = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  for (int axis = 0; axis < 2; ++axis) {
    outline = cut(outline, axis, box.low[axis] - margin, true);
    outline = cut(outline, axis, box.high[axis] + margin, false);
  }
  return outline;
}

Paths combine(ClipperLib::ClipType how, const Paths& first, const Paths& others, const Work& work) {
  Paths all = first;
  all.insert(all.end(), others.begin(), others.end());
  flat::charge_clipping(all, work);
  ClipperLib::Clipper clipper;
  clipper.AddPaths(first, ClipperLib::ptSubject, true);
  clipper.AddPaths(others, ClipperLib::ptClip, true);
  Paths made;
  clipper.Execute(how, made, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return made;
}

Paths combine(model::Operator op, const std::vector<Paths>& operands, const Work& work) {
  Paths made = operands.front();
  if (op == model::Operator::intersect) {
    for (std::size_t i = 1; i < operands.size(); ++i)
      made = combine(ClipperLib::ctIntersection, made, operands[i], work);
    return made;
  }
  Paths others;
  for (std::size_t i = 1; i < operands.size(); ++i) others.insert(others.end(), operands[i].begin(), operands[i].end());
  return combine(op == model::Operator::unite ? ClipperLib::ctUnion : ClipperLib::ctDifference, made, others, work);
}

/// Adds the union of paths on a grid.
void add_union(Projection& made, const Paths& paths, const PlaneGrid& grid, const Work& work) {
  Paths united = combine(ClipperLib::ctUnion, paths, {}, work);
  ClipperLib::CleanPolygons(united);
  for (const Path& path : united) {
    if (path.size() < 3) continue;
    const flat::Outline& outline = made.area.outlines.emplace_back(grid.to_outline(path));
    const facet::Box box = box_of(outline);
    const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    const bool is_coarser = made.coarse_size == 0 || grid.step() * made.coarse_size > made.coarse_step * size;
    if (grid.step() <= fine_enough * size || !is_coarser) continue;
    made.coarse_size = size;
    made.coarse_step = grid.step();
  }
}

facet::Box box_of(std::span<const facet::Box> boxes, std::span<const std::uint32_t> group) {
  facet::Box box;
  for (const std::uint32_t i : group) box = facet::hull(box, boxes[i]);
  return box;
}

/// Computes the section of a tree.
class SectionBuilder {
 public:
  SectionBuilder(const model::Tree& tree, const Work& work) : tree_(tree), work_(work) {
    const facet::Geometry scene = facet::make_geometry(tree);
    for (const facet::Convex& solid : scene.solids) {
      work.charge(projected_corner_steps * solid.vertices.size(), "projecting solids");
      leaves_.push_back(make_section(solid));
    }
    find_boxes();
    terms_ = union_terms(tree);
  }

  Projection make() {
    std::vector<facet::Box> boxes;
    for (const std::uint32_t term : terms_) boxes.push_back(boxes_[term]);
    Projection made;
    for (const std::vector<std::uint32_t>& group : group_boxes(boxes)) {
      const PlaneGrid grid(box_of(boxes, group));
      Paths paths;
      for (const std::uint32_t number : group) {
        const Paths more = make_paths(terms_[number], grid);
        paths.insert(paths.end(), more.begin(), more.end());
      }
      add_union(made, paths, grid, work_);
    }
    return made;
  }

 private:
  /// Computes bounds of each node's result.
  void find_boxes() {
    for (const model::Node& node : tree_.nodes) {
      facet::Box box = node.is_leaf ? box_of(leaves_[node.primitive]) : boxes_[node.children.front()];
      for (std::size_t i = 1; i < node.children.size() && node.op != model::Operator::subtract; ++i) {
        const facet::Box& other = boxes_[node.children[i]];
        box = node.op == model::Operator::unite ? facet::hull(box, other) : facet::common(box, other);
      }
      boxes_.push_back(box);
    }
  }

  /// A node of a term, and the part of the plane in which its result is needed.
  struct Wanted {
    std::uint32_t node = 0;
    facet::Box box;
  };

  std::vector<Wanted> nodes_below(std::uint32_t term) const {
    std::vector<Wanted> found{{term, boxes_[term]}};
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Wanted at = found[i];
      for (const std::uint32_t child : tree_.nodes[at.node].children)
        found.push_back({child, facet::common(at.box, boxes_[child])});
    }
    return found;
  }

  Paths make_paths(std::uint32_t term, const PlaneGrid& grid) {
    const std::vector<Wanted> nodes = nodes_below(term);
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const Wanted& one = nodes[i];
      const model::Node& node = tree_.nodes[one.node];
      Paths& made = made_[one.node];
      if (one.box.empty()) {
        made.clear();
      } else if (node.is_leaf) {
        made = {grid.to_path(cut_around(leaves_[node.primitive], one.box))};
      } else {
        std::vector<Paths> operands;
        for (const std::uint32_t child : node.children) operands.push_back(std::move(made_[child]));
        made = combine(node.op, operands, work_);
      }
    }
    return std::move(made_[term]);
  }

  const model::Tree& tree_;
  const Work& work_;
  std::vector<flat::Outline> leaves_;  ///< outline of each primitive
  std::vector<facet::Box> boxes_;      ///< bounds of each node
  std::vector<std::uint32_t> terms_;
  /// Results of nodes; each is kept until it is used.
  std::vector<Paths> made_ = std::vector<Paths>(tree_.nodes.size());
};

}  // namespace

Projection shadow(const model::Tree& tree, const Work& work) {
  std::vector<flat::Outline> outlines;
  std::vector<facet::Box> boxes;
  for (std::vector<glm::dvec2>& points : project_pieces(tree, work)) {
    outlines.push_back(make_hull(std::move(points)));
    boxes.push_back(box_of(outlines.back()));
  }
  Projection made;
  for (const std::vector<std::uint32_t>& group : group_boxes(boxes)) {
    const PlaneGrid grid(box_of(boxes, group));
    Paths paths;
    for (const std::uint32_t i : group) paths.push_back(grid.to_path(outlines[i]));
    add_union(made, paths, grid, work);
  }
  return made;
}

Projection section(const model::Tree& tree, const Work& work) {
  if (tree.root == model::no_index) return {};
  return SectionBuilder(tree, work).make();
}

}  // namespace csgsim::solids
