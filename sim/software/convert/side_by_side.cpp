#include "sim/software/convert/side_by_side.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "host/csg/tree_paths.h"
#include "sim/software/convert/division.h"
#include "sim/software/convert/local_tree.h"
#include "sim/software/convert/sets.h"

namespace csgsim::software::convert {

namespace {

/// Tests whether pairs of bodies without walls lie side by side.
class Pairs {
 public:
  Pairs(const Bodies& bodies, const Work& work) : bodies_(bodies), work_(work), tolerance_(bodies.tolerance) {}

  [[nodiscard]] bool are_apart(std::uint32_t one, std::uint32_t other) const {
    return is_before_a_face(one, other) || is_before_a_face(other, one) || has_edges_between(one, other);
  }

 private:
  /// Whether a body is entirely on the far side of a face of another one.
  [[nodiscard]] bool is_before_a_face(std::uint32_t body, std::uint32_t of) const {
    const std::vector<BodyFace>& faces = bodies_.bodies[of].faces;
    work_.charge(faces.size(), converting);
    return std::ranges::any_of(faces,
                               [&](const BodyFace& face) { return is_before(bodies_.bodies[body], face.halfspace); });
  }

  [[nodiscard]] bool is_before(const Body& body, const facet::Halfspace& face) const {
    const facet::Plane& plane = bodies_.faces[face.plane];
    std::size_t on = 0;
    for (const glm::dvec3& vertex : body.vertices) {
      const double height = plane.height(vertex - bodies_.reference);
      const double out = face.positive ? height : -height;
      if (out < -tolerance_) return false;
      if (out <= tolerance_) ++on;
    }
    // A body with fewer than three vertices on the plane touches it in a line or point.
    return on < 3 || std::ranges::find(body.faces, facet::Halfspace{face.plane, !face.positive},
                                       &BodyFace::halfspace) != body.faces.end();
  }

  /// Whether a plane along an edge of each separates them. Bodies with many edges are not tested, because it would take
  /// too long.
  [[nodiscard]] bool has_edges_between(std::uint32_t one, std::uint32_t other) const {
    constexpr std::size_t max_pairs = 1000;
    const Body& a = bodies_.bodies[one];
    const Body& b = bodies_.bodies[other];
    if (a.edges.empty() || b.edges.empty() || a.edges.size() * b.edges.size() > max_pairs) return false;
    work_.charge(a.edges.size() * b.edges.size(), converting);
    const auto way = [](const Body& solid, const std::array<std::uint32_t, 2>& edge) {
      return solid.vertices[edge[1]] - solid.vertices[edge[0]];
    };
    for (const auto& of_a : a.edges) {
      for (const auto& of_b : b.edges) {
        const glm::dvec3 across = glm::cross(way(a, of_a), way(b, of_b));
        const double length = glm::length(across);
        if (length == 0) continue;
        const glm::dvec3 normal = across / length;
        if (is_between(a, b, normal) || is_between(a, b, -normal)) return true;
      }
    }
    return false;
  }

  /// Whether no vertex of a is beyond one of b along the normal, and they touch in no more than an edge.
  [[nodiscard]] bool is_between(const Body& a, const Body& b, const glm::dvec3& normal) const {
    constexpr double far = std::numeric_limits<double>::infinity();
    const glm::dvec3& centre = bodies_.reference;
    double top = -far;
    for (const glm::dvec3& vertex : a.vertices) top = std::max(top, glm::dot(vertex - centre, normal));
    std::size_t on = 0;
    for (const glm::dvec3& vertex : b.vertices) {
      const double out = glm::dot(vertex - centre, normal) - top;
      if (out < -tolerance_) return false;
      if (out <= tolerance_) ++on;
    }
    return on < 3;
  }

  const Bodies& bodies_;
  const Work& work_;
  double tolerance_;
};

/// Whether the bodies (ascending) are combined only by unions.
bool are_united(const csg::PositiveTree& tree, const csg::TreePaths& paths, std::span<const std::uint32_t> bodies) {
  using NodeKind = LocalTree::Node::Kind;
  const LocalTree local(tree, paths, bodies);
  return std::ranges::all_of(local.nodes(), [](const LocalTree::Node& node) {
    return node.kind == NodeKind::unite || (node.kind == NodeKind::leaf && !node.complemented);
  });
}

/// Whether the body has a volume and polygons, and no wall among its faces.
bool is_whole(const Bodies& bodies, const Body& body) {
  const auto is_wall = [&](const BodyFace& face) { return bodies.planes.is_wall(face.halfspace.plane); };
  return !body.box.empty() && !body.polygons.empty() && std::ranges::none_of(body.faces, is_wall);
}

}  // namespace

std::vector<bool> side_by_side(const Bodies& bodies, const csg::PositiveTree& tree, const Work& work) {
  const auto count = static_cast<std::uint32_t>(bodies.bodies.size());
  std::vector<std::vector<std::uint32_t>> near(count);
  DisjointSets groups(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    near[i] = bodies.bodies_meeting(bodies.bodies[i].box);
    work.charge(near[i].size(), converting);
    for (const std::uint32_t other : near[i]) groups.join(i, other);
  }
  std::vector<std::vector<std::uint32_t>> members(count);
  for (std::uint32_t i = 0; i < count; ++i) members[groups.find(i)].push_back(i);
  const csg::TreePaths paths(tree);
  const Pairs pairs(bodies, work);
  std::vector<bool> found(count, false);
  for (const std::vector<std::uint32_t>& group : members) {
    const auto may_be_whole = [&](std::uint32_t body) { return is_whole(bodies, bodies.bodies[body]); };
    const auto is_free = [&](std::uint32_t body) {
      return std::ranges::all_of(near[body],
                                 [&](std::uint32_t other) { return other <= body || pairs.are_apart(body, other); });
    };
    if (group.empty() || !std::ranges::all_of(group, may_be_whole) || !are_united(tree, paths, group) ||
        !std::ranges::all_of(group, is_free))
      continue;
    for (const std::uint32_t body : group) found[body] = true;
  }
  return found;
}

}  // namespace csgsim::software::convert
