#include "host/facet/geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "host/model/limits.h"
#include "hw/base/error.h"

namespace csgsim::facet {

namespace {

std::vector<std::array<std::uint32_t, 2>> edges_of(const Solid& solid) {
  std::vector<std::array<std::uint32_t, 2>> edges = solid.edges;
  for (const Face& face : solid.faces) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const auto [low, high] = std::minmax(face.corners[i], face.corners[(i + 1) % face.corners.size()]);
      if (low != high) edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  edges.shrink_to_fit();
  return edges;
}

Box box_of(const Solid& solid) {
  return solid.curved ? Box{solid.curved->low, solid.curved->high} : facet::box_of(solid.vertices);
}

/// Turns solids into convexes one after another.
class GeometryMaker {
 public:
  GeometryMaker(PlaneTable& planes, QuadricTable& quadrics) : planes_(planes), quadrics_(quadrics) {}

  Convex make(Solid solid) {
    Convex convex;
    ++count_;
    convex.halfspaces.reserve(solid.faces.size());
    for (const Face& face : solid.faces) {
      const Halfspace halfspace = planes_.add(face.plane);
      if (is_new(halfspace)) convex.halfspaces.push_back(halfspace);
    }
    convex.edges = edges_of(solid);
    convex.box = box_of(solid);
    convex.vertices = std::move(solid.vertices);
    if (solid.curved) convex.quadrics.push_back(quadrics_.add(solid.curved->quadric, solid.curved->inward));
    return convex;
  }

 private:
  bool is_new(const Halfspace& halfspace) {
    if (planes_.planes().size() > last_of_.size()) last_of_.resize(2 * planes_.planes().size());
    return std::exchange(last_of_[halfspace.plane][halfspace.positive ? 1 : 0], count_) != count_;
  }

  PlaneTable& planes_;
  QuadricTable& quadrics_;
  std::uint32_t count_ = 0;                            ///< solids so far
  std::vector<std::array<std::uint32_t, 2>> last_of_;  ///< by plane and side: the number of the last solid that has it
};

/// Whether each coordinate is a number that is not too large.
bool is_at_hand(const glm::dvec3& point) {
  return std::abs(point.x) <= model::most_coordinate && std::abs(point.y) <= model::most_coordinate &&
         std::abs(point.z) <= model::most_coordinate;
}

void refuse_far(const Solid& solid) {
  const bool is_near = !solid.curved || (is_at_hand(solid.curved->low) && is_at_hand(solid.curved->high));
  if (is_near && std::all_of(solid.vertices.begin(), solid.vertices.end(), is_at_hand)) return;
  throw InputError(
      "it reaches farther than 1e12 from the origin, where numbers are too coarse to draw it; move it "
      "nearer, or scale it down");
}

Solid make_solid_at(const model::Tree& tree, std::uint32_t primitive, const Faceting& faceting) {
  try {
    Solid solid = make_solid(tree.primitives[primitive], faceting);
    refuse_far(solid);
    return solid;
  } catch (const InputError& error) {
    throw InputError(model::place_of(tree, primitive) + ": " + error.what());
  }
}

}  // namespace

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
  Box box;
  for (const glm::dvec3& point : points) box = hull(box, point);
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
    throw InputError("the faceting tolerance has to be a finite length above 0");
  }
  Faceting in_all_facets = faceting;
  in_all_facets.exact_curves = false;
  std::vector<Solid> solids;
  std::vector<Box> boxes;
  Box all;
  solids.reserve(tree.primitives.size());
  boxes.reserve(tree.primitives.size());
  for (std::uint32_t i = 0; i < tree.primitives.size(); ++i) {
    const bool is_faceted = i < faceting.faceted.size() && faceting.faceted[i];
    solids.push_back(make_solid_at(tree, i, is_faceted ? in_all_facets : faceting));
    boxes.push_back(box_of(solids.back()));
    all = hull(all, boxes.back());
  }
  Geometry geometry{{}, PlaneTable(all.empty() ? glm::dvec3(0) : all.centre(), all.empty() ? 1.0 : all.diagonal()), {}};
  geometry.quadrics = QuadricTable(geometry.planes.centre(), geometry.planes.diagonal());
  geometry.fast_spheres = faceting.exact_curves && faceting.fast_spheres;
  GeometryMaker maker(geometry.planes, geometry.quadrics);
  geometry.solids.reserve(solids.size());
  for (Solid& solid : solids) geometry.solids.push_back(maker.make(std::exchange(solid, {})));
  geometry.box = fold_boxes(tree, boxes);
  return geometry;
}

}  // namespace csgsim::facet
