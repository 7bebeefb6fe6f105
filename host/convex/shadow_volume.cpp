#include "host/convex/shadow_volume.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/convex/clip.h"

namespace csgsim::convex {

namespace {

enum class Attitude : std::uint8_t { facing, edge_on, averted };

/// A face and its attitude towards the light.
struct LitFace {
  facet::Plane plane;
  double height = 0;  ///< height of the light above the plane; a cosine for a directional light
  Attitude attitude = Attitude::averted;
};

/// A light relative to PlaneTable::centre(), and the tolerance within which it is treated as on a plane.
struct CentredLight {
  glm::dvec3 place;
  double weight = 0;
  double near = 0;

  [[nodiscard]] LitFace look(const facet::Plane& plane) const {
    const double height = glm::dot(plane.normal, place) + weight * plane.offset;
    if (std::abs(height) <= near) return {plane, height, Attitude::edge_on};
    return {plane, height, height > 0.0 ? Attitude::facing : Attitude::averted};
  }
};

CentredLight centred(const Light& light, const facet::PlaneTable& planes) {
  const glm::dvec3 place(light.place);
  if (light.place.w == 0.0) return {glm::normalize(place), 0.0, facet::coincidence_tolerance};
  const glm::dvec3 from_centre = place / light.place.w - planes.centre();
  return {from_centre, 1.0, facet::coincidence_tolerance * std::max(planes.diagonal(), glm::length(from_centre))};
}

facet::Plane silhouette_plane(const LitFace& facing, const LitFace& averted) {
  const glm::dvec3 normal = facing.height * averted.plane.normal - averted.height * facing.plane.normal;
  const double offset = facing.height * averted.plane.offset - averted.height * facing.plane.offset;
  const double length = glm::length(normal);
  return {normal / length, offset / length};
}

void add_once(std::vector<facet::Halfspace>& list, facet::Halfspace halfspace) {
  if (std::find(list.begin(), list.end(), halfspace) == list.end()) list.push_back(halfspace);
}

/// Adds a silhouette plane unless the list contains an equal one: edges in one plane with the light share it.
void add_once(std::vector<facet::Plane>& list, const facet::Plane& plane, double diagonal) {
  const bool known = std::any_of(list.begin(), list.end(), [&](const facet::Plane& other) {
    const glm::dvec3 turned = glm::abs(plane.normal - other.normal);
    return std::max({turned.x, turned.y, turned.z}) <= facet::coincidence_tolerance &&
           std::abs(plane.offset - other.offset) <= facet::coincidence_tolerance * diagonal;
  });
  if (!known) list.push_back(plane);
}

/// The shadow volume of a polytope if the light is inside it or on its faces.
void bound_inside(ShadowVolume& volume, const Polytope& polytope, const std::vector<LitFace>& lit) {
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (lit[i].attitude == Attitude::edge_on) add_once(volume.edge_on, polytope.faces[i].halfspace);
  }
}

/// Adds the half-spaces of the faces that face the light, and the silhouette planes behind their outline.
void cast(ShadowVolume& volume, const Polytope& polytope, const std::vector<LitFace>& lit, double diagonal) {
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (lit[i].attitude == Attitude::facing) add_once(volume.facing, polytope.faces[i].halfspace);
  }
  for (const Edge& edge : edges(polytope)) {
    const bool left = lit[edge.left].attitude == Attitude::facing;
    const bool right = lit[edge.right].attitude == Attitude::facing;
    if (left == right) continue;
    const std::uint32_t facing = left ? edge.left : edge.right;
    const std::uint32_t other = left ? edge.right : edge.left;
    if (lit[other].attitude == Attitude::edge_on) {
      add_once(volume.edge_on, polytope.faces[other].halfspace);
    } else {
      add_once(volume.silhouette, silhouette_plane(lit[facing], lit[other]), diagonal);
    }
  }
}

/// The corners of the faces that face the light, or all corners if there are none.
std::vector<glm::dvec3> lit_corners(const Polytope& polytope, const std::vector<LitFace>& lit, bool any_facing) {
  std::vector<bool> used(polytope.vertices.size(), !any_facing);
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (lit[i].attitude != Attitude::facing) continue;
    for (const std::uint32_t corner : polytope.faces[i].corners) used[corner] = true;
  }
  std::vector<glm::dvec3> corners;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) corners.push_back(polytope.vertices[i]);
  }
  return corners;
}

}  // namespace

ShadowVolume shadow_volume(const Polytope& polytope, const Light& light, const facet::PlaneTable& planes) {
  const CentredLight from = centred(light, planes);
  std::vector<LitFace> lit;
  lit.reserve(polytope.faces.size());
  for (const Face& face : polytope.faces) lit.push_back(from.look(outward_plane(face.halfspace, planes)));

  ShadowVolume volume;
  cast(volume, polytope, lit, planes.diagonal());
  const bool any_facing = !volume.facing.empty();
  if (!any_facing) bound_inside(volume, polytope, lit);

  volume.corners = lit_corners(polytope, lit, any_facing);
  if (from.weight == 0.0) volume.directions.push_back(-from.place);
  for (glm::dvec3& corner : volume.corners) {
    if (from.weight != 0.0) volume.directions.push_back(corner - from.place);
    corner += planes.centre();
  }
  return volume;
}

}  // namespace csgsim::convex
