#include "sim/software/convert/exact_faces.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sim/software/convert/division.h"

namespace csgsim::software::convert {

namespace {

/// Whether the body has a half-space and its opposite.
bool has_opposites(const Body& body) {
  std::vector<std::uint32_t> planes;
  for (const BodyFace& face : body.faces) planes.push_back(face.halfspace.plane);
  std::ranges::sort(planes);
  return std::ranges::adjacent_find(planes) != planes.end();
}

bool reaches_walls(const WholePlanes& planes, const Body& body) {
  return std::ranges::any_of(body.sides, [&](const BodySide& side) { return planes.is_wall(side.plane); });
}

/// Bounds a body by the outermost walls if its half-spaces do not intersect before them.
void add_walls(const WholePlanes& planes, Body& body) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool is_last : {false, true}) {
      const std::uint32_t wall = planes.wall(axis, is_last ? WholePlanes::walls - 1 : 0);
      body.faces.push_back({.halfspace = {wall, is_last}, .box = {}});
    }
  }
}

}  // namespace

std::vector<ExactFaces::Outline> ExactFaces::outlines_of(const facet::Solid& solid,
                                                         std::span<const std::uint32_t> face_of, std::size_t faces) {
  std::vector<std::vector<std::uint32_t>> at(solid.vertices.size());
  for (std::size_t i = 0; i < solid.faces.size(); ++i)
    for (const std::uint32_t corner : solid.faces[i].corners) at[corner].push_back(face_of[i]);
  std::vector<Outline> outlines(faces);
  for (std::size_t i = 0; i < solid.faces.size(); ++i) {
    Outline& outline = outlines[face_of[i]];
    for (const std::uint32_t corner : solid.faces[i].corners) {
      outline.corners.push_back(corner);
      outline.neighbours.insert(outline.neighbours.end(), at[corner].begin(), at[corner].end());
    }
  }
  for (std::uint32_t i = 0; i < faces; ++i) {
    std::vector<std::uint32_t>& neighbours = outlines[i].neighbours;
    std::ranges::sort(neighbours);
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    std::erase(neighbours, i);
  }
  return outlines;
}

/// The nearest vertex of the face that a corner of the sheet may be rounded to.
std::uint32_t ExactFaces::vertex_at(std::uint32_t corner, const Outline& outline, const Body& body) const {
  constexpr double max_deviation = 0.1;  // relative to the tolerance
  const glm::dvec3 place = sheet_.place(corner, max_deviation * tolerance_ / planes_.unit()) * planes_.unit();
  std::uint32_t found = no_vertex;
  double nearest = tolerance_;
  for (const std::uint32_t vertex : outline.corners) {
    const double far = glm::distance(place, body.vertices[vertex] - reference_);
    if (far > nearest) continue;
    nearest = far;
    found = vertex;
  }
  return found;
}

void ExactFaces::store(const Region& region, const Outline& outline, BodyFace& face, Body& body) const {
  face.first_side = static_cast<std::uint32_t>(body.sides.size());
  face.sides = static_cast<std::uint32_t>(region.planes.size());
  face.box = {};
  if (region.empty()) return;
  for (std::size_t i = 0; i < region.planes.size(); ++i)
    body.sides.push_back({region.planes[i], vertex_at(region.corners[i], outline, body)});
  const Bounds bounds = sheet_.bounds(region);
  face.box = bounds.box;
  face.radius = bounds.radius;
  body.box = body.box.empty() ? face.box
                              : UnitBox{glm::min(body.box.low, face.box.low), glm::max(body.box.high, face.box.high)};
}

void ExactFaces::cut(std::span<const Outline> outlines, Body& body) {
  for (std::size_t i = 0; i < body.faces.size(); ++i) {
    BodyFace& face = body.faces[i];
    Region region = sheet_.begin(face.halfspace.plane);
    for (const std::uint32_t neighbour : outlines[i].neighbours) {
      if (region.empty()) break;
      work_.charge(1 + region.corners.size() / 4, converting);
      region = sheet_.clip(region, body.faces[neighbour].halfspace);
    }
    store(region, outlines[i], face, body);
  }
}

/// Cuts each face by all other faces of the body; skips those far from the remaining region.
void ExactFaces::cut_by_all(std::span<const Outline> outlines, Body& body) {
  body.sides.clear();
  body.box = {};
  const Outline none;
  for (std::size_t i = 0; i < body.faces.size(); ++i) {
    BodyFace& face = body.faces[i];
    Region region = sheet_.begin(face.halfspace.plane);
    Bounds bounds = sheet_.bounds(region);
    for (const BodyFace& other : body.faces) {
      if (other.halfspace.plane == face.halfspace.plane) continue;
      work_.charge(1, converting);
      const double out = planes_.height(other.halfspace, bounds.middle);
      if (out < -bounds.radius - place_error) continue;
      region = sheet_.clip(region, other.halfspace);
      if (region.empty()) break;
      bounds = sheet_.bounds(region);
    }
    store(region, i < outlines.size() ? outlines[i] : none, face, body);
  }
}

/// Whether the face has a side along this plane from `start` to `end`.
bool ExactFaces::ends_at(const Body& body, const BodyFace& face, std::uint32_t along, const Meeting& start,
                         const Meeting& end) const {
  const std::span<const BodySide> sides = body.sides_of(face);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i].plane != along) continue;
    const std::uint32_t before = sides[(i + sides.size() - 1) % sides.size()].plane;
    const std::uint32_t after = sides[(i + 1) % sides.size()].plane;
    // Both points are on the face's plane and on `along`, so the third plane decides.
    return planes_.side(start, before) == 0 && planes_.side(end, after) == 0;
  }
  return false;
}

/// Whether each side of each face is also a side of another face in the opposite direction. A closed surface that is
/// convex at each edge is convex, and equals the intersection of all half-spaces.
bool ExactFaces::is_closed(const Body& body) const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_plane;
  for (std::uint32_t i = 0; i < body.faces.size(); ++i) by_plane.emplace_back(body.faces[i].halfspace.plane, i);
  std::ranges::sort(by_plane);
  for (const BodyFace& face : body.faces) {
    const std::uint32_t plane = face.halfspace.plane;
    const std::span<const BodySide> sides = body.sides_of(face);
    if (sides.empty()) return false;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const std::uint32_t along = sides[i].plane;
      if (along < plane) continue;
      const auto other = std::ranges::lower_bound(by_plane, std::pair(along, 0U));
      if (other == by_plane.end() || other->first != along) return false;
      const BodyFace& beyond = body.faces[other->second];
      const Meeting start = planes_.meet(plane, sides[(i + sides.size() - 1) % sides.size()].plane, along);
      const Meeting end = planes_.meet(plane, along, sides[(i + 1) % sides.size()].plane);
      // Faces whose normals point to different sides of the body run along their common edge in the same direction.
      const bool is_alike = beyond.halfspace.positive != face.halfspace.positive;
      if (!ends_at(body, beyond, plane, is_alike ? start : end, is_alike ? end : start)) return false;
    }
  }
  // Only sides along planes with higher indices were checked; every edge needs one of each kind.
  std::size_t higher = 0;
  for (const BodyFace& face : body.faces)
    higher += static_cast<std::size_t>(std::ranges::count_if(
        body.sides_of(face), [&](const BodySide& side) { return side.plane > face.halfspace.plane; }));
  return 2 * higher == body.sides.size();
}

void ExactFaces::find_balls(Body& body) const {
  if (body.vertices.empty()) return;
  for (const glm::dvec3& vertex : body.vertices) body.middle += (vertex - reference_) / planes_.unit();
  body.middle /= static_cast<double>(body.vertices.size());
  const glm::dvec3 farthest = glm::max(body.middle - body.box.low, body.box.high - body.middle);
  body.outer = glm::length(farthest) + place_error;
  body.inner = body.outer;
  for (const BodyFace& face : body.faces)
    body.inner = std::min(body.inner, -planes_.height(face.halfspace, body.middle) - place_error);
}

void ExactFaces::complete(const facet::Solid& solid, std::span<const std::uint32_t> face_of, Body& body) {
  body.vertices = solid.vertices;
  if (has_opposites(body)) return;
  const std::vector<Outline> outlines = outlines_of(solid, face_of, body.faces.size());
  cut(outlines, body);
  if (!is_closed(body)) cut_by_all(outlines, body);
  if (reaches_walls(planes_, body)) {
    add_walls(planes_, body);
    cut_by_all(outlines, body);
  }
  if (body.box.empty()) return;
  find_balls(body);
}

}  // namespace csgsim::software::convert
