#include "host/facet/geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "host/facet/solid_at.h"
#include "host/model/limits.h"
#include "hw/base/error.h"

namespace csgsim::facet {

namespace {

using Edges = std::vector<std::array<std::uint32_t, 2>>;

/// Calls visit(low, high) for each edge of each face, and for the edges that belong to no face.
template <class Visit>
void for_each_edge(const Solid& solid, const Visit& visit) {
  for (const auto& [low, high] : solid.edges) visit(low, high);
  for (const Face& face : solid.faces) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const std::uint32_t next = face.corners[i + 1 < face.corners.size() ? i + 1 : 0];
      const auto [low, high] = std::minmax(face.corners[i], next);
      if (low != high) visit(low, high);
    }
  }
}

/// All edges without duplicates, in order. Grouping by the first vertex leaves short lists to sort.
Edges collect_edges(const Solid& solid) {
  std::vector<std::size_t> begins(solid.vertices.size() + 1);
  for_each_edge(solid, [&](std::uint32_t low, std::uint32_t /*high*/) { ++begins[low]; });
  std::exclusive_scan(begins.begin(), begins.end(), begins.begin(), std::size_t{0});
  std::vector<std::uint32_t> others(begins.back());
  std::vector<std::size_t> ends = begins;
  for_each_edge(solid, [&](std::uint32_t low, std::uint32_t high) { others[ends[low]++] = high; });
  Edges edges;
  edges.reserve(others.size() / 2 + 1);
  for (std::uint32_t low = 0; low < solid.vertices.size(); ++low) {
    const auto begin = others.begin() + static_cast<std::ptrdiff_t>(begins[low]);
    const auto end = others.begin() + static_cast<std::ptrdiff_t>(ends[low]);
    std::sort(begin, end);
    const auto last = std::unique(begin, end);
    for (auto high = begin; high != last; ++high) edges.push_back({low, *high});
  }
  edges.shrink_to_fit();
  return edges;
}

Box box_of(const Solid& solid) {
  return solid.curved ? Box{solid.curved->low, solid.curved->high} : facet::box_of(solid.vertices);
}

/// The parts of a solid that are stored until the size of the model is known. The corners of its faces, which need the
/// most memory, are dropped.
struct Draft {
  std::vector<Plane> planes;  ///< planes of the faces
  std::vector<glm::dvec3> vertices;
  Edges edges;
  Box box;
  std::optional<CurvedSurface> curved;
};

Draft make_draft(Solid solid) {
  Draft draft;
  draft.planes.reserve(solid.faces.size());
  for (const Face& face : solid.faces) draft.planes.push_back(face.plane);
  draft.edges = collect_edges(solid);
  draft.box = box_of(solid);
  draft.vertices = std::move(solid.vertices);
  draft.curved = solid.curved;
  return draft;
}

/// Converts solids to Convex, one after another.
class GeometryMaker {
 public:
  GeometryMaker(PlaneTable& planes, QuadricTable& quadrics) : planes_(planes), quadrics_(quadrics) {}

  Convex make(Draft draft) {
    Convex convex;
    ++count_;
    convex.halfspaces.reserve(draft.planes.size());
    for (const Plane& plane : draft.planes) {
      const Halfspace halfspace = planes_.add(plane);
      if (is_new(halfspace)) convex.halfspaces.push_back(halfspace);
    }
    convex.edges = std::move(draft.edges);
    convex.box = draft.box;
    convex.vertices = std::move(draft.vertices);
    if (draft.curved) convex.quadrics.push_back(quadrics_.add(draft.curved->quadric, draft.curved->inward));
    return convex;
  }

 private:
  bool is_new(const Halfspace& halfspace) {
    if (planes_.planes().size() > last_user_.size()) last_user_.resize(2 * planes_.planes().size());
    return std::exchange(last_user_[halfspace.plane][halfspace.positive ? 1 : 0], count_) != count_;
  }

  PlaneTable& planes_;
  QuadricTable& quadrics_;
  std::uint32_t count_ = 0;                              ///< number of solids converted
  std::vector<std::array<std::uint32_t, 2>> last_user_;  ///< last solid that uses each plane and side
};

/// Whether each coordinate is a number within the supported range.
bool is_in_range(const glm::dvec3& point) {
  return std::abs(point.x) <= model::max_coordinate && std::abs(point.y) <= model::max_coordinate &&
         std::abs(point.z) <= model::max_coordinate;
}

void reject_far(const Solid& solid) {
  const bool is_near = !solid.curved || (is_in_range(solid.curved->low) && is_in_range(solid.curved->high));
  if (is_near && std::all_of(solid.vertices.begin(), solid.vertices.end(), is_in_range)) return;
  throw InputError(
      "the solid extends farther than 1e12 from the origin, where numbers are too coarse to draw it; move it "
      "closer, or scale it down");
}

}  // namespace

Solid make_solid_at(const model::Tree& tree, std::uint32_t primitive, const Faceting& faceting) {
  try {
    Solid solid = make_solid(tree.primitives[primitive], faceting);
    reject_far(solid);
    return solid;
  } catch (const InputError& error) {
    throw InputError(model::location_text(tree, primitive) + ": " + error.what());
  }
}

Box hull(const Box& a, const Box& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

Box hull(const Box& box, const glm::dvec3& point) { return hull(box, Box{point, point}); }

Box common(const Box& a, const Box& b) {
  if (a.empty() || b.empty()) return {};
  return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

Box box_of(std::span<const glm::dvec3> points) {
  if (points.empty()) return {};
  Box box{points.front(), points.front()};
  for (const glm::dvec3& point : points) {
    // Equivalent to glm::min() and glm::max(), which need several times as many instructions.
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = point[axis] < box.low[axis] ? point[axis] : box.low[axis];
      box.high[axis] = point[axis] > box.high[axis] ? point[axis] : box.high[axis];
    }
  }
  return box;
}

Box fold_boxes(const model::Tree& tree, const std::vector<Box>& boxes) {
  if (tree.root == model::no_index) return {};
  std::vector<Box> folded(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const model::Node& node = tree.nodes[i];
    if (node.is_leaf) {
      folded[i] = boxes[node.primitive];
      continue;
    }
    folded[i] = folded[node.children.front()];
    for (std::size_t child = 1; child < node.children.size(); ++child) {
      const Box& other = folded[node.children[child]];
      switch (node.op) {
        case model::Operator::unite: folded[i] = hull(folded[i], other); break;
        case model::Operator::intersect: folded[i] = common(folded[i], other); break;
        case model::Operator::subtract: break;
      }
    }
  }
  return folded[tree.root];
}

bool Geometry::is_faceted() const {
  return std::ranges::all_of(solids, [](const Convex& solid) { return solid.quadrics.empty(); });
}

std::uint64_t Geometry::halfspaces() const {
  std::uint64_t sum = 0;
  for (const Convex& solid : solids) sum += solid.halfspaces.size() + solid.quadrics.size();
  return sum;
}

Geometry make_geometry(const model::Tree& tree, const Faceting& faceting) {
  if (faceting.tolerance && !(*faceting.tolerance > 0.0 && std::isfinite(*faceting.tolerance))) {
    throw InputError("the faceting tolerance must be a finite length above 0");
  }
  Faceting all_faceted = faceting;
  all_faceted.exact_curves = false;
  std::vector<Draft> drafts;
  std::vector<Box> boxes;
  Box all;
  drafts.reserve(tree.primitives.size());
  boxes.reserve(tree.primitives.size());
  for (std::uint32_t i = 0; i < tree.primitives.size(); ++i) {
    const bool is_faceted = i < faceting.faceted.size() && faceting.faceted[i];
    drafts.push_back(make_draft(make_solid_at(tree, i, is_faceted ? all_faceted : faceting)));
    boxes.push_back(drafts.back().box);
    all = hull(all, boxes.back());
  }
  Geometry geometry{{}, PlaneTable(all.empty() ? glm::dvec3(0) : all.centre(), all.empty() ? 1.0 : all.diagonal()), {}};
  geometry.quadrics = QuadricTable(geometry.planes.centre(), geometry.planes.diagonal());
  geometry.fast_spheres = faceting.exact_curves && faceting.fast_spheres;
  GeometryMaker maker(geometry.planes, geometry.quadrics);
  geometry.solids.reserve(drafts.size());
  for (Draft& draft : drafts) geometry.solids.push_back(maker.make(std::exchange(draft, {})));
  geometry.box = fold_boxes(tree, boxes);
  return geometry;
}

}  // namespace csgsim::facet
