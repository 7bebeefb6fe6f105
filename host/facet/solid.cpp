#include "host/facet/solid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "host/facet/covered_ball.h"
#include "host/facet/curved.h"
#include "host/model/degrees.h"
#include "host/model/fragments.h"
#include "host/model/hypotenuse.h"
#include "hw/base/error.h"

namespace csgsim::facet {

namespace {

constexpr std::uint64_t max_faces = 4'000'000;

using Corners = std::vector<std::uint32_t>;

Solid box(const model::Cube& cube) {
  const glm::dvec3 low = cube.center ? -cube.size / 2.0 : glm::dvec3(0.0);
  const glm::dvec3 high = low + cube.size;
  Solid solid;
  for (unsigned corner = 0; corner < 8; ++corner) {
    solid.vertices.emplace_back((corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                                (corner & 4U) != 0 ? high.z : low.z);
  }
  solid.faces = {
      {{{-1, 0, 0}, low.x}, {0, 2, 6, 4}},  {{{1, 0, 0}, -high.x}, {1, 3, 7, 5}}, {{{0, -1, 0}, low.y}, {0, 1, 5, 4}},
      {{{0, 1, 0}, -high.y}, {2, 3, 7, 6}}, {{{0, 0, -1}, low.z}, {0, 1, 3, 2}},  {{{0, 0, 1}, -high.z}, {4, 5, 7, 6}},
  };
  return solid;
}

/// The planes of the lateral faces between two rings of regular polygons; all of these planes share the parameters. In
/// the meridian half-plane at the middle of a facet, a polygon with n corners has the radius r cos(180/n).
class LateralPlanes {
 public:
  LateralPlanes(const Ring& low, const Ring& high, std::uint32_t count) {
    const double apothem = model::cos_degrees(180.0 / count);
    const double low_radius = low.radius * apothem;
    const double high_radius = high.radius * apothem;
    const double rise = high.z - low.z;
    const double run = high_radius - low_radius;
    const double length = model::hypotenuse(rise, run);
    radial_ = rise / length;
    axial_ = -run / length;
    offset_ = -(radial_ * low_radius + axial_ * low.z);
  }

  /// The plane of the facet whose middle is in the given direction.
  [[nodiscard]] Plane at(const glm::dvec2& middle) const {
    return {{radial_ * middle.x, radial_ * middle.y, axial_}, offset_};
  }

 private:
  double radial_;
  double axial_;
  double offset_;
};

/// The convex solid between a stack of rings, lowest first, closed by flat caps where the outermost radius is not 0.
Solid lathe(std::span<const Ring> stack, std::uint32_t count) {
  if (static_cast<std::uint64_t>(count) * stack.size() > max_faces) {
    throw InputError("more than " + std::to_string(max_faces) +
                     " facets in one solid; reduce them with $fn, $fa or $fs");
  }
  Solid solid;
  solid.vertices.reserve(count * stack.size());
  solid.faces.reserve(count * stack.size());
  std::vector<Corners> rings;
  const std::vector<glm::dvec2> corners = directions(count, 0.0);
  for (const Ring& ring : stack) rings.push_back(add_ring(solid, ring, corners));
  if (stack.front().radius > 0.0) solid.faces.push_back({{{0, 0, -1}, stack.front().z}, rings.front()});
  const std::vector<glm::dvec2> middles = directions(count, 0.5);
  for (std::size_t level = 0; level + 1 < stack.size(); ++level) {
    const LateralPlanes planes(stack[level], stack[level + 1], count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = i + 1 < count ? i + 1 : 0;
      solid.faces.push_back(
          {planes.at(middles[i]), {rings[level][i], rings[level][next], rings[level + 1][next], rings[level + 1][i]}});
    }
  }
  if (stack.back().radius > 0.0) solid.faces.push_back({{{0, 0, 1}, -stack.back().z}, rings.back()});
  return solid;
}

/// The faceting of a shape in its own space: the tolerance is divided by the maximum stretch of the transform.
struct Local {
  std::optional<double> tolerance;
  std::optional<double> fragments;

  [[nodiscard]] model::FacetControl control(const model::FacetControl& own) const {
    return fragments ? model::FacetControl{*fragments, own.fa, own.fs} : own;
  }
};

Solid ball(const model::Sphere& sphere, const Local& local) {
  if (local.tolerance) return covered_ball(sphere.radius, *local.tolerance);
  const std::uint32_t count = model::fragments(sphere.radius, local.control(sphere.facets));
  const std::uint32_t levels = model::rings(count);
  std::vector<Ring> stack;
  for (std::uint32_t i = levels; i-- > 0;) {
    const double polar = 180.0 * (static_cast<double>(i) + 0.5) / levels;
    stack.push_back({sphere.radius * model::sin_degrees(polar), sphere.radius * model::cos_degrees(polar)});
  }
  return lathe(stack, count);
}

Solid frustum(const model::Cylinder& cylinder, const Local& local) {
  const double radius = std::max(cylinder.r1, cylinder.r2);
  // The distance to a slanted side is measured perpendicular to it.
  const double slant = cylinder.height / model::hypotenuse(cylinder.height, cylinder.r1 - cylinder.r2);
  const std::uint32_t count = local.tolerance ? fragments_within(radius, *local.tolerance / slant)
                                              : model::fragments(radius, local.control(cylinder.facets));
  const double low = cylinder.center ? -cylinder.height / 2.0 : 0.0;
  const Ring stack[] = {{cylinder.r1, low}, {cylinder.r2, low + cylinder.height}};
  return lathe(stack, count);
}

/// Newell's normal of a polygon, and the offset of its centroid.
Plane polygon_plane(std::span<const glm::dvec3> points, const Corners& corners) {
  glm::dvec3 normal{0};
  glm::dvec3 centroid{0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& here = points[corners[i]];
    const glm::dvec3& next = points[corners[(i + 1) % corners.size()]];
    normal += glm::cross(here - points[corners[0]], next - points[corners[0]]);
    centroid += here;
  }
  normal = glm::normalize(normal);
  centroid /= static_cast<double>(corners.size());
  return {normal, -glm::dot(normal, centroid)};
}

Solid polyhedron(const model::Polyhedron& shape) {
  Solid solid;
  solid.vertices = shape.points;
  for (std::size_t i = 0; i < shape.faces.size(); ++i) {
    const Plane plane = shape.planes.empty() ? polygon_plane(shape.points, shape.faces[i])
                                             : Plane{glm::dvec3(shape.planes[i]), shape.planes[i].w};
    solid.faces.push_back({plane, shape.faces[i]});
  }
  return solid;
}

struct SolidMaker {
  Local local;
  bool is_curved;

  Solid operator()(const model::Cube& shape) const { return box(shape); }
  Solid operator()(const model::Sphere& shape) const { return is_curved ? curved_hull(shape) : ball(shape, local); }
  Solid operator()(const model::Cylinder& shape) const {
    return is_curved ? curved_hull(shape) : frustum(shape, local);
  }
  Solid operator()(const model::Polyhedron& shape) const { return polyhedron(shape); }
};

/// An upper bound of the factor by which a matrix stretches vectors, exact if its columns are orthogonal: the square
/// root of the largest row sum of its Gram matrix.
double stretch(const glm::dmat3& linear) {
  const glm::dmat3 gram = glm::transpose(linear) * linear;
  double most = 0;
  for (int i = 0; i < 3; ++i) most = std::max(most, std::abs(gram[i].x) + std::abs(gram[i].y) + std::abs(gram[i].z));
  return std::sqrt(most);
}

/// Ensures that products of three lengths are doubles with full precision.
void require_size(const Solid& solid, const glm::dmat3& linear) {
  constexpr double smallest = 1e-90;
  constexpr double largest = 1e90;
  double reach = 0;
  for (const glm::dvec3& vertex : solid.vertices) reach = std::max(reach, glm::length(linear * vertex));
  const double volume = std::abs(glm::determinant(linear));
  if (!(reach > smallest && reach < largest && volume > smallest)) {
    throw InputError("the solid is too small or too large; keep lengths between 1e-30 and 1e90 model units");
  }
}

}  // namespace

Solid make_solid(const model::Primitive& primitive, const Faceting& faceting) {
  const glm::dmat3 linear(primitive.transform);
  Local local{std::nullopt, faceting.fragments};
  if (faceting.tolerance) local.tolerance = *faceting.tolerance / stretch(linear);
  const bool is_curved = stays_curved(primitive, faceting);
  Solid solid = std::visit(SolidMaker{local, is_curved}, primitive.shape);
  require_size(solid, linear);
  const glm::dvec3 shift(primitive.transform[3]);
  const glm::dmat3 normals = glm::transpose(glm::inverse(linear));
  for (glm::dvec3& vertex : solid.vertices) vertex = linear * vertex + shift;
  for (Face& face : solid.faces) {
    const glm::dvec3 normal = normals * face.plane.normal;
    const double length = glm::length(normal);
    const double offset = face.plane.offset - glm::dot(normal, shift);
    face.plane = {normal / length, offset / length};
  }
  if (is_curved) solid.curved = curved_surface(primitive);
  return solid;
}

}  // namespace csgsim::facet
