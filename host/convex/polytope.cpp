#include "host/convex/polytope.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "host/convex/carver.h"
#include "host/convex/clip.h"

namespace csgsim::convex {

namespace {

/// Marks the faces of the initial box.
constexpr std::uint32_t no_plane = std::numeric_limits<std::uint32_t>::max();

Polytope cuboid(const glm::dvec3& low, const glm::dvec3& high) {
  Polytope polytope;
  for (unsigned corner = 0; corner < 8; ++corner) {
    polytope.vertices.emplace_back((corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                                   (corner & 4U) != 0 ? high.z : low.z);
  }
  const facet::Halfspace none{no_plane, true};
  polytope.faces = {{none, {0, 4, 6, 2}}, {none, {1, 3, 7, 5}}, {none, {0, 1, 5, 4}},
                    {none, {2, 6, 7, 3}}, {none, {0, 2, 3, 1}}, {none, {4, 5, 7, 6}}};
  return polytope;
}

/// Above this number, half-spaces are not clipped in the given order. Around a round solid, each cut would add as many
/// vertices as a ring has faces, and the next cut would remove them again; in a scattered order each cut adds few
/// vertices.
constexpr std::size_t max_in_order = 10'000;

/// A bijective hash of numbers.
constexpr std::uint32_t scattered(std::uint32_t number) {
  number = (number ^ (number >> 16U)) * 0x7feb352dU;
  number = (number ^ (number >> 15U)) * 0x846ca68bU;
  return number ^ (number >> 16U);
}

/// The order in which `count` half-spaces are clipped.
std::vector<std::uint32_t> clipping_order(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  if (count > max_in_order) std::ranges::sort(order, {}, scattered);
  return order;
}

/// Sorts the faces from clipping order into the order of the half-spaces.
void sort_faces(std::vector<Face>& faces, std::span<const facet::Halfspace> halfspaces,
                const std::vector<std::uint32_t>& order) {
  std::vector<Face> sorted(halfspaces.size());
  std::size_t next = 0;
  for (const std::uint32_t i : order)
    if (next < faces.size() && faces[next].halfspace == halfspaces[i]) sorted[i] = std::move(faces[next++]);
  std::erase_if(sorted, [](const Face& face) { return face.corners.empty(); });
  faces = std::move(sorted);
}

}  // namespace

std::vector<Edge> edges(const Polytope& polytope) {
  struct Side {
    std::array<std::uint32_t, 2> ends;  ///< lower index first
    std::uint32_t face;
    bool forward;  ///< the face runs from the lower index to the higher one
  };
  std::vector<Side> sides;
  for (std::size_t face = 0; face < polytope.faces.size(); ++face) {
    const std::vector<std::uint32_t>& corners = polytope.faces[face].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t here = corners[i];
      const std::uint32_t next = corners[(i + 1) % corners.size()];
      sides.push_back({{std::min(here, next), std::max(here, next)}, static_cast<std::uint32_t>(face), here < next});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return std::pair(a.ends, !a.forward) < std::pair(b.ends, !b.forward); });
  std::vector<Edge> found;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    found.push_back({sides[i].ends, sides[i].face, sides[i + 1].face});
  }
  return found;
}

facet::Box box_of(const Polytope& polytope) { return facet::box_of(polytope.vertices); }

double volume(const Polytope& polytope) {
  double six_times = 0;
  for (const Face& face : polytope.faces) {
    const glm::dvec3 apex = polytope.vertices.front();
    const glm::dvec3 first = polytope.vertices[face.corners.front()] - apex;
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
      const glm::dvec3 second = polytope.vertices[face.corners[i]] - apex;
      const glm::dvec3 third = polytope.vertices[face.corners[i + 1]] - apex;
      six_times += glm::dot(first, glm::cross(second, third));
    }
  }
  return six_times / 6.0;
}

Polytope intersection(const facet::Box& box, std::span<const facet::Halfspace> halfspaces,
                      const facet::PlaneTable& planes, const Work& work) {
  if (box.empty()) return {};
  // Wide enough that none of the box's faces remains.
  const glm::dvec3 margin(0.1 * box.diagonal() + 10.0 * tolerance(planes));
  Carver carver(cuboid(box.low - margin, box.high + margin), planes);
  const std::vector<std::uint32_t> order = clipping_order(halfspaces.size());
  for (const std::uint32_t i : order) {
    carver.clip(halfspaces[i]);
    work.charge(carver.steps(), "intersecting half-spaces");
    if (carver.empty()) return {};
  }
  Polytope polytope = carver.take();
  // The half-spaces bound the solid, unless planes that differ by less than the tolerance were merged.
  const bool unbounded = std::any_of(polytope.faces.begin(), polytope.faces.end(),
                                     [](const Face& face) { return face.halfspace.plane == no_plane; });
  if (unbounded) return {};
  sort_faces(polytope.faces, halfspaces, order);
  return polytope;
}

std::vector<facet::Halfspace> add_box_halfspaces(const facet::Box& box, facet::PlaneTable& planes) {
  std::vector<facet::Halfspace> walls;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    walls.push_back(planes.add({normal, -box.high[axis]}));
    walls.push_back(planes.add({-normal, box.low[axis]}));
  }
  return walls;
}

Polytope make_polytope(const facet::Convex& solid, const facet::PlaneTable& planes, const Work& work) {
  return intersection({solid.box.low - planes.centre(), solid.box.high - planes.centre()}, solid.halfspaces, planes,
                      work);
}

}  // namespace csgsim::convex
