#include "sim/judges/quadric_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace csgsim::judges {

namespace {

constexpr PlaceRect no_places{infinity, infinity, -infinity, -infinity};

/// Two pixels, in places.
constexpr double margin = 4.0;

glm::dvec3 to_double(const Vector& v) { return {v[0].to_double(), v[1].to_double(), v[2].to_double()}; }

PlaceRect hull(const PlaceRect& a, const PlaceRect& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// Projects solids in doubles.
class Projector {
 public:
  explicit Projector(const ExactCamera& camera)
      : perspective_(camera.is_perspective),
        eye_(to_double(camera.eye)),
        forward_(per_length(to_double(camera.forward))),
        right_(per_length(to_double(camera.right)) / camera.right_step.to_double()),
        down_(-per_length(to_double(camera.up)) / camera.up_step.to_double()),
        near_(camera.near.to_double() / camera.axis_length.to_double()),
        picture_{-1.0 * camera.width, -1.0 * camera.height, 1.0 * camera.width, 1.0 * camera.height} {}

  /// The places with the margin, clipped to the picture.
  [[nodiscard]] PlaceRect places_around(const facet::Convex& solid) const {
    const PlaceRect rect = places(solid);
    return {std::max(rect.x0 - margin, picture_.x0), std::max(rect.y0 - margin, picture_.y0),
            std::min(rect.x1 + margin, picture_.x1), std::min(rect.y1 + margin, picture_.y1)};
  }

  [[nodiscard]] PlaceRect places(const facet::Convex& solid) const {
    PlaceRect rect = no_places;
    for (const glm::dvec3& vertex : solid.vertices) {
      if (!perspective_ || depth(vertex) >= near_) add(rect, vertex);
    }
    if (perspective_) {
      for (const auto& [first, second] : solid.edges) add_cut(rect, solid.vertices[first], solid.vertices[second]);
    }
    return rect;
  }

  /// The components of a direction along the view's axes: right and down in half pixels, and forward in units of the
  /// view direction's length.
  [[nodiscard]] glm::dvec3 components(const glm::dvec3& d) const {
    return {glm::dot(d, right_), glm::dot(d, down_), glm::dot(d, forward_)};
  }

 private:
  static glm::dvec3 per_length(const glm::dvec3& v) { return v / glm::dot(v, v); }

  /// Depth in units of the view direction's length.
  [[nodiscard]] double depth(const glm::dvec3& point) const { return glm::dot(point - eye_, forward_); }

  void add(PlaceRect& rect, const glm::dvec3& point) const {
    const glm::dvec3 d = point - eye_;
    const double over = perspective_ ? depth(point) : 1.0;
    const double x = glm::dot(d, right_) / over;
    const double y = glm::dot(d, down_) / over;
    rect = hull(rect, {x, y, x, y});
  }

  void add_cut(PlaceRect& rect, const glm::dvec3& a, const glm::dvec3& b) const {
    const double from = depth(a) - near_;
    const double to = depth(b) - near_;
    if ((from < 0.0) != (to < 0.0)) add(rect, a + from / (from - to) * (b - a));
  }

  bool perspective_;
  glm::dvec3 eye_;
  glm::dvec3 forward_;
  glm::dvec3 right_;
  glm::dvec3 down_;
  double near_;
  PlaceRect picture_;
};

/// The point of [low, high] at which a x^2 + b x is greatest if a < 0, else `low`.
double peak(double a, double b, double low, double high) {
  return a < 0.0 ? std::clamp(-b / (2.0 * a), low, high) : low;
}

}  // namespace

std::vector<PlaceRect> quadric_reaches(const facet::Geometry& geometry, const ExactCamera& camera) {
  const Projector projector(camera);
  std::vector<PlaceRect> reaches(geometry.quadrics.quadrics().size(), no_places);
  for (const facet::Convex& solid : geometry.solids) {
    if (solid.quadrics.empty()) continue;
    const PlaceRect places = projector.places_around(solid);
    for (const facet::QuadricSide& side : solid.quadrics) {
      reaches[side.quadric] = hull(reaches[side.quadric], places);
    }
  }
  return reaches;
}

std::vector<PlaceRect> solid_reaches(const facet::Geometry& geometry, const ExactCamera& camera) {
  const Projector projector(camera);
  std::vector<PlaceRect> reaches;
  reaches.reserve(geometry.solids.size());
  for (const facet::Convex& solid : geometry.solids) reaches.push_back(projector.places(solid));
  return reaches;
}

double minimum(const FilterQuadratic& quadratic, const PlaceRect& rectangle) {
  return -maximum(
      {-quadratic.c, -quadratic.x, -quadratic.y, -quadratic.xx, -quadratic.xy, -quadratic.yy, quadratic.error},
      rectangle);
}

double apex_shift(const facet::QuadricTable& quadrics, std::uint32_t index, const ExactCamera& camera) {
  const Vector from_centre = camera.eye - to_exact(quadrics.centre());
  const glm::dvec3 from_apex = to_double(from_centre - to_exact(quadrics.quadrics()[index].origin));
  const Projector projector(camera);
  const glm::dvec3 places = projector.components(from_apex);
  // The distance of a corner from the middle in places, which are half pixels, equals the picture's size in pixels.
  return (std::hypot(places.x, places.y) + std::abs(places.z) * std::hypot(camera.width, camera.height)) / 2.0;
}

double maximum(const FilterQuadratic& quadratic, const PlaceRect& rectangle) {
  if (rectangle.x0 > rectangle.x1 || rectangle.y0 > rectangle.y1) return 0.0;
  double most = -infinity;
  const auto include = [&](double x, double y) {
    most = std::max(most, quadratic.c + x * (quadratic.x + quadratic.xx * x + quadratic.xy * y) +
                              y * (quadratic.y + quadratic.yy * y));
  };
  for (const double x : {rectangle.x0, rectangle.x1}) {
    for (const double y : {rectangle.y0, rectangle.y1}) include(x, y);
    include(x, peak(quadratic.yy, quadratic.y + quadratic.xy * x, rectangle.y0, rectangle.y1));
  }
  for (const double y : {rectangle.y0, rectangle.y1})
    include(peak(quadratic.xx, quadratic.x + quadratic.xy * y, rectangle.x0, rectangle.x1), y);
  const double determinant = 4.0 * quadratic.xx * quadratic.yy - quadratic.xy * quadratic.xy;
  if (determinant > 0.0) {
    const double x = (quadratic.xy * quadratic.y - 2.0 * quadratic.yy * quadratic.x) / determinant;
    const double y = (quadratic.xy * quadratic.x - 2.0 * quadratic.xx * quadratic.y) / determinant;
    if (rectangle.x0 <= x && x <= rectangle.x1 && rectangle.y0 <= y && y <= rectangle.y1) include(x, y);
  }
  return most;
}

}  // namespace csgsim::judges
