#include "host/effects/reflection.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace csgsim::effects {

namespace {

/// The reflection in a plane.
class Mirroring {
 public:
  /// Reflection in the plane normal . p + offset = 0.
  Mirroring(const glm::dvec3& normal, double offset)
      : turn_(glm::dmat3(1) - 2.0 * glm::outerProduct(normal, normal)), shift_(-2.0 * offset * normal) {}

  [[nodiscard]] glm::dvec3 place(const glm::dvec3& p) const { return turn_ * p + shift_; }
  [[nodiscard]] glm::dvec3 direction(const glm::dvec3& d) const { return turn_ * d; }
  [[nodiscard]] facet::Plane plane(const facet::Plane& p) const {
    return {turn_ * p.normal, p.offset + glm::dot(p.normal, shift_)};
  }
  [[nodiscard]] glm::dmat4 matrix() const {
    glm::dmat4 matrix(turn_);
    matrix[3] = glm::dvec4(shift_, 1);
    return matrix;
  }

 private:
  glm::dmat3 turn_;
  glm::dvec3 shift_;
};

/// The plane with its offset relative to the origin.
facet::Plane absolute(const facet::Plane& plane, const glm::dvec3& centre) {
  return {plane.normal, plane.offset - glm::dot(plane.normal, centre)};
}

Mirroring make_mirroring(const facet::Geometry& geometry, std::uint32_t plane) {
  const facet::Plane mirror = absolute(geometry.planes.planes()[plane], geometry.planes.centre());
  return {mirror.normal, mirror.offset};
}

facet::Convex reflected(const facet::Convex& solid, const Mirroring& mirroring,
                        const std::vector<facet::Halfspace>& of_planes) {
  facet::Convex result;
  for (const facet::Halfspace& one : solid.halfspaces) {
    const facet::Halfspace& positive = of_planes[one.plane];
    result.halfspaces.push_back({positive.plane, positive.positive == one.positive});
  }
  for (const glm::dvec3& vertex : solid.vertices) {
    result.vertices.push_back(mirroring.place(vertex));
    result.box = facet::hull(result.box, result.vertices.back());
  }
  result.edges = solid.edges;
  return result;
}

}  // namespace

Reflected reflected(const model::Tree& tree, const facet::Geometry& geometry, std::uint32_t plane) {
  const Mirroring mirroring = make_mirroring(geometry, plane);
  const glm::dvec3& centre = geometry.planes.centre();
  facet::Box all;
  for (const facet::Convex& solid : geometry.solids) all = facet::hull(all, solid.box);
  Reflected result;
  facet::Geometry other{{}, facet::PlaneTable(mirroring.place(centre), all.diagonal()), {}};
  for (const facet::Plane& one : geometry.planes.planes())
    result.of_planes.push_back(other.planes.add(mirroring.plane(absolute(one, centre))));
  auto other_tree = std::make_shared<model::Tree>(tree);
  for (model::Primitive& one : other_tree->primitives) one.transform = mirroring.matrix() * one.transform;
  std::vector<facet::Box> boxes;
  for (const facet::Convex& solid : geometry.solids) {
    other.solids.push_back(reflected(solid, mirroring, result.of_planes));
    boxes.push_back(other.solids.back().box);
  }
  other.box = facet::fold_boxes(tree, boxes);
  result.tree = std::move(other_tree);
  result.geometry = std::make_shared<facet::Geometry>(std::move(other));
  return result;
}

lighting::Lighting reflected(const lighting::Lighting& lighting, const facet::Geometry& geometry, std::uint32_t plane,
                             const view::Camera& camera) {
  const facet::Plane mirror = absolute(geometry.planes.planes()[plane], geometry.planes.centre());
  const view::Basis axes = view::basis(camera);
  const auto turned = [&](const glm::dvec3& v) {
    return glm::dvec3(glm::dot(v, axes.right), glm::dot(v, axes.up), glm::dot(v, axes.forward));
  };
  const Mirroring mirroring(turned(mirror.normal), mirror.offset + glm::dot(mirror.normal, camera.eye));
  lighting::Lighting result = lighting;
  for (lighting::CameraSpaceLight& light : result.lights)
    light.where = light.is_point ? mirroring.place(light.where) : mirroring.direction(light.where);
  return result;
}

}  // namespace csgsim::effects
