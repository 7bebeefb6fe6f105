#include "sim/software/convert/bodies.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "host/facet/solid.h"

namespace csgsim::software::convert {

namespace {

/// In single precision, outwards.
csg::BoxIndex::Box index_box(const UnitBox& box) {
  csg::BoxIndex::Box result;
  constexpr float far = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    result.low[i] = std::nextafter(static_cast<float>(box.low[axis]), -far);
    result.high[i] = std::nextafter(static_cast<float>(box.high[axis]), far);
  }
  return result;
}

class BodyMaker {
 public:
  BodyMaker(facet::PlaneTable& planes, const WholePlanes& whole)
      : planes_(planes), whole_(whole), unit_(whole.unit()) {}

  Body make(const facet::Solid& solid) {
    Body body;
    for (const glm::dvec3& vertex : solid.vertices) stretch(body.box, vertex);
    std::vector<std::uint32_t> face_of(solid.faces.size());
    std::map<std::pair<std::uint32_t, bool>, std::uint32_t> known;
    for (std::size_t i = 0; i < solid.faces.size(); ++i) {
      const facet::Halfspace halfspace = planes_.add(solid.faces[i].plane);
      const auto [entry, is_new] = known.try_emplace({halfspace.plane, halfspace.positive}, body.faces.size());
      face_of[i] = entry->second;
      if (is_new) body.faces.push_back({halfspace, {}, {}, 0, 0});
      for (const std::uint32_t corner : solid.faces[i].corners)
        stretch(body.faces[face_of[i]].box, solid.vertices[corner]);
    }
    find_neighbours(solid, face_of, body);
    find_polygons(solid, face_of, body);
    find_balls(solid, body);
    for (BodyFace& face : body.faces)
      if (face.box.empty()) face.box = body.box;
    return body;
  }

 private:
  void stretch(UnitBox& box, const glm::dvec3& vertex) const {
    const glm::dvec3 place = place_of(vertex);
    const bool is_first = box.empty();
    box.low = is_first ? place - box_margin : glm::min(box.low, place - box_margin);
    box.high = is_first ? place + box_margin : glm::max(box.high, place + box_margin);
  }

  static void find_neighbours(const facet::Solid& solid, const std::vector<std::uint32_t>& face_of, Body& body) {
    std::vector<std::vector<std::uint32_t>> at(solid.vertices.size());
    for (std::size_t i = 0; i < solid.faces.size(); ++i)
      for (const std::uint32_t corner : solid.faces[i].corners) at[corner].push_back(face_of[i]);
    for (std::size_t i = 0; i < solid.faces.size(); ++i) {
      std::vector<std::uint32_t>& neighbours = body.faces[face_of[i]].neighbours;
      for (const std::uint32_t corner : solid.faces[i].corners)
        neighbours.insert(neighbours.end(), at[corner].begin(), at[corner].end());
    }
    for (std::uint32_t i = 0; i < body.faces.size(); ++i) {
      std::vector<std::uint32_t>& neighbours = body.faces[i].neighbours;
      std::ranges::sort(neighbours);
      neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
      std::erase(neighbours, i);
    }
  }

  static void find_polygons(const facet::Solid& solid, const std::vector<std::uint32_t>& face_of, Body& body) {
    for (std::size_t i = 0; i < solid.faces.size(); ++i) {
      const facet::Face& face = solid.faces[i];
      if (face.corners.empty()) {
        body.polygons.clear();
        return;
      }
      BodyPolygon& polygon = body.polygons.emplace_back(BodyPolygon{face_of[i], face.corners});
      if (glm::dot(twice_area(solid, face), face.plane.normal) < 0) std::ranges::reverse(polygon.corners);
    }
    std::ranges::stable_sort(body.polygons, {}, &BodyPolygon::face);
    for (std::uint32_t i = 0; i < body.polygons.size(); ++i) {
      BodyFace& face = body.faces[body.polygons[i].face];
      if (face.polygons++ == 0) face.first_polygon = i;
    }
  }

  [[nodiscard]] glm::dvec3 place_of(const glm::dvec3& vertex) const { return (vertex - planes_.centre()) / unit_; }

  void find_balls(const facet::Solid& solid, Body& body) const {
    if (solid.vertices.empty()) return;
    for (const glm::dvec3& vertex : solid.vertices) body.middle += place_of(vertex);
    body.middle /= static_cast<double>(solid.vertices.size());
    for (const glm::dvec3& vertex : solid.vertices)
      body.outer = std::max(body.outer, glm::distance(body.middle, place_of(vertex)));
    body.outer += box_margin;
    body.inner = body.outer;
    for (const BodyFace& face : body.faces)
      body.inner = std::min(body.inner, -whole_.height(face.halfspace, body.middle) - box_margin);
  }

  static glm::dvec3 twice_area(const facet::Solid& solid, const facet::Face& face) {
    const glm::dvec3 first = solid.vertices[face.corners.front()];
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
      sum += glm::cross(solid.vertices[face.corners[i]] - first, solid.vertices[face.corners[i + 1]] - first);
    return sum;
  }

  facet::PlaneTable& planes_;
  const WholePlanes& whole_;
  double unit_;
};

csg::BoxIndex index_of(const std::vector<Body>& bodies) {
  std::vector<csg::BoxIndex::Entry> entries;
  for (std::uint32_t i = 0; i < bodies.size(); ++i)
    if (!bodies[i].box.empty()) entries.push_back({index_box(bodies[i].box), i});
  return csg::BoxIndex(entries);
}

}  // namespace

std::vector<std::uint32_t> Bodies::meeting(const UnitBox& box) const {
  std::vector<std::uint32_t> found;
  index.meeting(index_box(box), found);
  return found;
}

BallIs Bodies::ball_is(const Body& body, const glm::dvec3& middle, double radius, std::uint32_t but) const {
  const double far = glm::distance(middle, body.middle);
  if (far > body.outer + radius) return BallIs::outside;
  if (far < body.inner - radius) return BallIs::inside;
  bool is_inside = true;
  for (const BodyFace& face : body.faces) {
    if (face.halfspace.plane == but) continue;
    const double height = planes.height(face.halfspace, middle);
    if (height > radius) return BallIs::outside;
    if (height > -radius) is_inside = false;
  }
  return is_inside ? BallIs::inside : BallIs::neither;
}

Bodies make_bodies(const model::Tree& tree, const facet::Faceting& faceting, Neighbours neighbours) {
  facet::Geometry geometry = facet::make_geometry(tree, faceting);
  WholePlanes planes(geometry.planes);
  std::vector<Body> bodies;
  BodyMaker maker(geometry.planes, planes);
  for (const model::Primitive& primitive : tree.primitives)
    bodies.push_back(maker.make(facet::make_solid(primitive, faceting)));
  if (neighbours == Neighbours::all) {
    for (Body& body : bodies) {
      body.polygons.clear();
      for (BodyFace& face : body.faces) {
        face.neighbours.clear();
        face.polygons = 0;
      }
    }
  }
  csg::BoxIndex index = index_of(bodies);
  return {std::move(geometry), std::move(planes), std::move(bodies), std::move(index)};
}

}  // namespace csgsim::software::convert
