#include "host/solids/plan.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <utility>

#include "host/convex/pieces.h"
#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"
#include "host/model/subtree.h"

namespace csgsim::solids {

namespace {

using Points = std::vector<glm::dvec2>;

/// Solids are truncated where they extend farther than this multiple of the size of the result, and parts are treated
/// as far apart if they are apart along z by more than this multiple of their width. This keeps the tolerance of clip()
/// within 1e-6 of that size.
constexpr double times_apart = 4096;

/// An interval along z of the result of a tree, and the scale along z that makes the interval about as high as it is
/// wide.
struct Slab {
  double low = 0;
  double high = 0;
  double scale = 1;
};

/// The intervals in which solids begin and end, and the long intervals between these, in ascending order.
std::vector<Slab> split_into_slabs(const facet::Box& rest, std::span<const facet::Convex> solids) {
  const double width = std::max(rest.high.x - rest.low.x, rest.high.y - rest.low.y);
  std::vector<double> ends{rest.low.z, rest.high.z};
  for (const facet::Convex& solid : solids) {
    for (const double z : {solid.box.low.z, solid.box.high.z}) {
      if (z > rest.low.z && z < rest.high.z) ends.push_back(z);
    }
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Slab> slabs{{rest.low.z, rest.high.z}};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double low = ends[i - 1] + width;
    const double high = ends[i] - width;
    if (high - low <= times_apart * width) continue;
    slabs.back().high = low;
    slabs.push_back({low, high, width / (high - low)});
    slabs.push_back({high, rest.high.z});
  }
  return slabs;
}

facet::Box scaled(facet::Box box, double scale) {
  box.low.z *= scale;
  box.high.z *= scale;
  return box;
}

facet::Plane scaled(const facet::Plane& plane, double scale) {
  const glm::dvec3 normal(plane.normal.x, plane.normal.y, plane.normal.z / scale);
  const double length = glm::length(normal);
  return {normal / length, plane.offset / length};
}

/// The solids within a slab, truncated near the result, and scaled along z.
facet::Geometry cut_off(const model::Tree& tree, const facet::Geometry& whole, const Slab& slab) {
  facet::Box region = whole.box;
  const double margin = glm::length(glm::dvec2(region.high - region.low));
  region.low = {region.low.x - margin, region.low.y - margin, slab.low};
  region.high = {region.high.x + margin, region.high.y + margin, slab.high};
  region = scaled(region, slab.scale);
  facet::Geometry cut{{}, facet::PlaneTable(region.centre(), region.diagonal()), region};
  for (std::uint32_t i = 0; i < whole.solids.size(); ++i) {
    facet::Convex& solid = cut.solids.emplace_back();
    const facet::Box box = scaled(whole.solids[i].box, slab.scale);
    solid.box = facet::common(box, region);
    if (solid.box.empty()) {
      solid.box = {};
      continue;
    }
    for (const facet::Face& face : facet::make_solid(tree.primitives[i]).faces)
      solid.halfspaces.push_back(cut.planes.add(scaled(face.plane, slab.scale)));
    if (solid.box != box) {
      for (const facet::Halfspace& wall : convex::add_box_halfspaces(region, cut.planes))
        solid.halfspaces.push_back(wall);
    }
    std::ranges::sort(solid.halfspaces, {},
                      [](const facet::Halfspace& side) { return std::pair(side.plane, side.positive); });
    solid.halfspaces.erase(std::unique(solid.halfspaces.begin(), solid.halfspaces.end()), solid.halfspaces.end());
  }
  return cut;
}

bool reaches_far(const facet::Geometry& geometry) {
  return geometry.planes.diagonal() > times_apart * geometry.box.diagonal();
}

void add_pieces(std::vector<Points>& plan, const facet::Geometry& geometry, const model::Tree& tree, const Work& work) {
  const glm::dvec2 centre(geometry.planes.centre());
  for (const convex::Piece& piece : convex::pieces(geometry, csg::make_positive_tree(tree), convex::max_pieces, work)) {
    Points& points = plan.emplace_back();
    for (const glm::dvec3& vertex : piece.polytope.vertices) points.push_back(glm::dvec2(vertex) + centre);
  }
}

void add_term(std::vector<Points>& plan, const model::Tree& tree, const Work& work) {
  const facet::Geometry geometry = facet::make_geometry(tree);
  for (const facet::Convex& solid : geometry.solids)
    work.charge(projected_corner_steps * solid.vertices.size(), "projecting solids");
  if (tree.nodes[tree.root].is_leaf) {
    plan.emplace_back(geometry.solids.front().vertices.begin(), geometry.solids.front().vertices.end());
    return;
  }
  if (geometry.box.empty()) return;
  const std::vector<Slab> slabs = split_into_slabs(geometry.box, geometry.solids);
  if (slabs.size() == 1 && !reaches_far(geometry)) {
    add_pieces(plan, geometry, tree, work);
    return;
  }
  for (const Slab& slab : slabs) add_pieces(plan, cut_off(tree, geometry, slab), tree, work);
}

/// The first node of a subtree, and the number of leaves before it.
struct Begin {
  std::uint32_t node = 0;
  std::uint32_t primitive = 0;
};

std::vector<Begin> subtree_begins(const model::Tree& tree) {
  std::vector<Begin> begins(tree.nodes.size());
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    const model::Node& node = tree.nodes[i];
    begins[i] = node.is_leaf ? Begin{i, node.primitive} : begins[node.children.front()];
  }
  return begins;
}

}  // namespace

std::vector<std::uint32_t> union_terms(const model::Tree& tree) {
  std::vector<std::uint32_t> terms;
  if (tree.root == model::no_index) return terms;
  std::vector<std::uint32_t> waiting{tree.root};
  while (!waiting.empty()) {
    const std::uint32_t at = waiting.back();
    waiting.pop_back();
    const model::Node& node = tree.nodes[at];
    if (node.is_leaf || node.op != model::Operator::unite) {
      terms.push_back(at);
    } else {
      waiting.insert(waiting.end(), node.children.rbegin(), node.children.rend());
    }
  }
  return terms;
}

std::vector<Points> project_pieces(const model::Tree& tree, const Work& work) {
  std::vector<Points> plan;
  const std::vector<Begin> begins = subtree_begins(tree);
  for (const std::uint32_t term : union_terms(tree))
    add_term(plan, model::subtree(tree, term, begins[term].node, begins[term].primitive), work);
  return plan;
}

}  // namespace csgsim::solids
