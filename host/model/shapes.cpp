#include "host/model/shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <variant>

#include "host/model/hypotenuse.h"

namespace csgsim::model {

namespace {

/// A facet of a cylinder is one of the ends if the cosine of the angle between its normal and the z axis is greater.
constexpr double end_cosine = 1 - 1e-9;

/// Results of the queries for a shape without a curved surface.
struct Flat {
  std::string_view name;

  [[nodiscard]] bool has_flat_faces() const { return true; }
  [[nodiscard]] bool is_flat(const glm::dvec3& /*normal*/) const { return true; }
  [[nodiscard]] double facet_angle(double facets) const { return 2 * std::numbers::pi / facets; }
  [[nodiscard]] std::optional<glm::dvec3> normal_at(const glm::dvec3& /*vertex*/,
                                                    const glm::dvec3& /*of_facet*/) const {
    return std::nullopt;
  }
  [[nodiscard]] std::optional<SurfacePosition> surface_position_at(const glm::dvec2& /*direction*/,
                                                                   double /*part*/) const {
    return std::nullopt;
  }
};

struct Ball : Flat {
  double radius;

  [[nodiscard]] bool has_flat_faces() const { return false; }
  [[nodiscard]] bool is_flat(const glm::dvec3& /*normal*/) const { return false; }
  [[nodiscard]] double facet_angle(double facets) const { return std::sqrt(4 * std::numbers::pi / facets); }
  [[nodiscard]] std::optional<glm::dvec3> normal_at(const glm::dvec3& vertex, const glm::dvec3& /*of_facet*/) const {
    return glm::length(vertex) > 0 ? std::optional(glm::normalize(vertex)) : std::nullopt;
  }
  [[nodiscard]] std::optional<SurfacePosition> surface_position_at(const glm::dvec2& direction, double part) const {
    const double angle = std::numbers::pi * (part - 0.5);
    const glm::dvec3 normal(direction * std::cos(angle), std::sin(angle));
    return SurfacePosition{normal * radius, normal};
  }
};

struct Frustum : Flat {
  const Cylinder& of;

  [[nodiscard]] bool is_flat(const glm::dvec3& normal) const { return std::abs(normal.z) > end_cosine; }
  [[nodiscard]] std::optional<glm::dvec3> normal_at(const glm::dvec3& vertex, const glm::dvec3& of_facet) const {
    // A cone's apex has no normal; the facet's normal is used there.
    const bool is_apex = hypotenuse(vertex.x, vertex.y) <= 1e-9 * std::max(of.r1, of.r2);
    const glm::dvec2 around = is_apex ? glm::dvec2(of_facet) : glm::dvec2(vertex);
    return normal_towards(around / glm::length(around));
  }
  [[nodiscard]] std::optional<SurfacePosition> surface_position_at(const glm::dvec2& direction, double part) const {
    const double radius = of.r1 + (of.r2 - of.r1) * part;
    const double z = of.height * (part - (of.center ? 0.5 : 0.0));
    return SurfacePosition{{direction * radius, z}, normal_towards(direction)};
  }

 private:
  [[nodiscard]] glm::dvec3 normal_towards(const glm::dvec2& direction) const {
    return glm::normalize(glm::dvec3(direction * of.height, of.r1 - of.r2));
  }
};

Flat make_surface(const Cube& /*cube*/) { return {"cube"}; }
Ball make_surface(const Sphere& sphere) { return {{"sphere"}, sphere.radius}; }
Frustum make_surface(const Cylinder& cylinder) { return {{"cylinder"}, cylinder}; }
Flat make_surface(const Polyhedron& /*polyhedron*/) { return {"polyhedron"}; }

/// Calls the function with the surface of the shape.
template <class Function>
auto visit_surface(const Shape& shape, const Function& function) {
  return std::visit([&](const auto& one) { return function(make_surface(one)); }, shape);
}

}  // namespace

std::string_view name_of(const Shape& shape) {
  return visit_surface(shape, [](const auto& surface) { return surface.name; });
}

bool has_flat_faces(const Shape& shape) {
  return visit_surface(shape, [](const auto& surface) { return surface.has_flat_faces(); });
}

bool is_flat(const Shape& shape, const glm::dvec3& normal) {
  return visit_surface(shape, [&](const auto& surface) { return surface.is_flat(normal); });
}

double facet_angle(const Shape& shape, std::size_t facet_count) {
  return visit_surface(shape,
                       [&](const auto& surface) { return surface.facet_angle(static_cast<double>(facet_count)); });
}

std::optional<glm::dvec3> normal_at(const Shape& shape, const glm::dvec3& vertex, const glm::dvec3& facet_normal) {
  return visit_surface(shape, [&](const auto& surface) { return surface.normal_at(vertex, facet_normal); });
}

std::optional<SurfacePosition> surface_position_at(const Shape& shape, const glm::dvec2& direction,
                                                   double height_fraction) {
  return visit_surface(shape,
                       [&](const auto& surface) { return surface.surface_position_at(direction, height_fraction); });
}

}  // namespace csgsim::model
