#include "host/facet/curved.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <variant>

#include "host/model/degrees.h"

namespace csgsim::facet {

namespace {

using Real = long double;
using Vec = glm::vec<3, Real>;

/// Sizes of the hulls: sides of the prism around a cylinder; meridians and parallels of the mesh around a ball.
constexpr std::uint32_t hull_sides = 24;
constexpr std::uint32_t hull_meridians = 16;
constexpr std::uint32_t hull_parallels = 8;

double low_end(const model::Cylinder& cylinder) { return cylinder.center ? -cylinder.height / 2.0 : 0.0; }

bool is_cone(const model::Cylinder& cylinder) {
  return std::abs(cylinder.r1 - cylinder.r2) >= min_taper * std::max(cylinder.r1, cylinder.r2);
}

/// The columns of a transform's linear part, and the rows of its inverse.
struct Inverse {
  std::array<Vec, 3> columns;
  std::array<Vec, 3> rows;

  explicit Inverse(const glm::dmat4& transform)
      : columns{Vec(transform[0]), Vec(transform[1]), Vec(transform[2])},
        rows{glm::cross(columns[1], columns[2]), glm::cross(columns[2], columns[0]),
             glm::cross(columns[0], columns[1])} {
    const Real determinant = glm::dot(columns[0], rows[0]);
    for (Vec& row : rows) row /= determinant;
  }
};

/// Half the extent along each axis of the image of a disc (two columns) or ball (three columns).
glm::dvec3 half_size(const Inverse& matrix, std::size_t columns, double radius) {
  Vec squares(0);
  for (std::size_t i = 0; i < columns; ++i) squares += matrix.columns[i] * matrix.columns[i];
  return glm::dvec3(std::sqrt(squares.x), std::sqrt(squares.y), std::sqrt(squares.z)) * radius;
}

CurvedSurface make_surface(const model::Sphere& sphere, const glm::dmat4& transform) {
  const Inverse matrix(transform);
  CurvedSurface surface;
  surface.quadric.origin = glm::dvec3(transform[3]);
  for (std::size_t i = 0; i < 3; ++i) surface.quadric.to_unit[i] = glm::dvec3(matrix.rows[i] / Real{sphere.radius});
  const glm::dvec3 half = half_size(matrix, 3, sphere.radius);
  surface.low = surface.quadric.origin - half;
  surface.high = surface.quadric.origin + half;
  return surface;
}

CurvedSurface make_surface(const model::Cylinder& cylinder, const glm::dmat4& transform) {
  const Inverse matrix(transform);
  const Vec shift(transform[3]);
  const Real low = low_end(cylinder);
  const Real height = cylinder.height;
  CurvedSurface surface;
  Quadric& quadric = surface.quadric;
  if (is_cone(cylinder)) {
    const Real rise = Real{cylinder.r1} - Real{cylinder.r2};
    const Real apex = low + height * Real{cylinder.r1} / rise;
    quadric.kind = QuadricKind::cone;
    quadric.origin = glm::dvec3(matrix.columns[2] * apex + shift);
    quadric.to_unit = {glm::dvec3(matrix.rows[0]), glm::dvec3(matrix.rows[1]),
                       glm::dvec3(matrix.rows[2] * std::abs(rise) / height)};
    surface.inward = glm::dvec3(rise > 0 ? -matrix.columns[2] : matrix.columns[2]);
  } else {
    const Real radius = (Real{cylinder.r1} + Real{cylinder.r2}) / 2;
    quadric.kind = QuadricKind::cylinder;
    quadric.origin = glm::dvec3(matrix.columns[2] * (low + height / 2) + shift);
    quadric.to_unit = {glm::dvec3(matrix.rows[0] / radius), glm::dvec3(matrix.rows[1] / radius), glm::dvec3(0)};
  }
  const glm::dvec3 first(matrix.columns[2] * low + shift);
  const glm::dvec3 last(matrix.columns[2] * (low + height) + shift);
  const glm::dvec3 at_first = half_size(matrix, 2, cylinder.r1);
  const glm::dvec3 at_last = half_size(matrix, 2, cylinder.r2);
  surface.low = glm::min(first - at_first, last - at_last);
  surface.high = glm::max(first + at_first, last + at_last);
  return surface;
}

void add_edges(Solid& solid, const std::vector<std::uint32_t>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto [low, high] = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
    if (low != high) solid.edges.push_back({low, high});
  }
}

}  // namespace

namespace {

std::vector<glm::dvec2> compute_directions(std::uint32_t sides, double turn) {
  std::vector<glm::dvec2> all;
  all.reserve(sides);
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double around = 360.0 * (i + turn) / sides;
    all.emplace_back(model::cos_degrees(around), model::sin_degrees(around));
  }
  return all;
}

/// Cache of the most recent directions: most models have many solids with the same number of sides.
class DirectionCache {
 public:
  const std::vector<glm::dvec2>& find(std::uint32_t sides, double turn) {
    const auto is_it = [&](const Known& one) { return one.around.size() == sides && one.turn == turn; };
    if (const auto found = std::ranges::find_if(known_, is_it); found != known_.end()) return found->around;
    Known& oldest = known_[next_];
    next_ = (next_ + 1) % known_.size();
    oldest = {turn, compute_directions(sides, turn)};
    return oldest.around;
  }

 private:
  struct Known {
    double turn = 0;
    std::vector<glm::dvec2> around;
  };

  std::array<Known, 4> known_;
  std::size_t next_ = 0;
};

/// Directions with more sides are not cached: their cost is small relative to the rest of the solid, and they would
/// need too much memory.
constexpr std::uint32_t max_cached_sides = 4096;

}  // namespace

std::vector<glm::dvec2> directions(std::uint32_t side_count, double turn) {
  if (side_count > max_cached_sides) return compute_directions(side_count, turn);
  thread_local DirectionCache last;
  return last.find(side_count, turn);
}

std::vector<std::uint32_t> add_ring(Solid& solid, const Ring& ring, std::span<const glm::dvec2> around) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(around.size());
  for (const glm::dvec2& direction : around) {
    if (numbers.empty() || ring.radius > 0.0)
      solid.vertices.emplace_back(ring.radius * direction.x, ring.radius * direction.y, ring.z);
    numbers.push_back(static_cast<std::uint32_t>(solid.vertices.size() - 1));
  }
  return numbers;
}

bool keeps_balls(const glm::dmat4& transform) {
  const std::array<glm::dvec3, 3> columns{glm::dvec3(transform[0]), glm::dvec3(transform[1]), glm::dvec3(transform[2])};
  const double square = glm::dot(columns[0], columns[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (!(std::abs(glm::dot(columns[i], columns[i]) - square) <= 2 * ball_tolerance * square)) return false;
    if (!(std::abs(glm::dot(columns[i], columns[next])) <= ball_tolerance * square)) return false;
  }
  return true;
}

bool stays_curved(const model::Primitive& primitive, const Faceting& faceting) {
  const auto is_round = [&](const model::FacetControl& own) {
    return std::isfinite(own.fn) && !(own.fn > 0.0 && own.fn < faceting.min_round_sides);
  };
  if (!faceting.exact_curves) return false;
  if (const auto* sphere = std::get_if<model::Sphere>(&primitive.shape))
    return is_round(sphere->facets) && (!faceting.fast_spheres || keeps_balls(primitive.transform));
  if (faceting.fast_spheres) return false;
  const auto* cylinder = std::get_if<model::Cylinder>(&primitive.shape);
  return cylinder != nullptr && is_round(cylinder->facets);
}

Solid curved_hull(const model::Sphere& sphere) {
  Solid solid;
  // Offset by half a mesh in both directions, so that no face of the hull is closer to the centre than the radius.
  const double outer =
      sphere.radius / (model::cos_degrees(180.0 / hull_meridians) * model::cos_degrees(90.0 / hull_parallels));
  const std::vector<glm::dvec2> around = directions(hull_meridians, 0.5);
  std::vector<std::uint32_t> last;
  for (std::uint32_t row = 0; row <= hull_parallels; ++row) {
    const double polar = 180.0 * row / hull_parallels;
    const std::vector<std::uint32_t> ring =
        add_ring(solid, {outer * model::sin_degrees(polar), outer * model::cos_degrees(polar)}, around);
    add_edges(solid, ring);
    for (std::size_t i = 0; i < last.size(); ++i) solid.edges.push_back({last[i], ring[i]});
    last = ring;
  }
  return solid;
}

Solid curved_hull(const model::Cylinder& cylinder) {
  Solid solid;
  const double outer = 1.0 / model::cos_degrees(180.0 / hull_sides);
  const double low = low_end(cylinder);
  const double high = low + cylinder.height;
  const std::vector<glm::dvec2> around = directions(hull_sides, 0.5);
  const std::vector<std::uint32_t> first = add_ring(solid, {cylinder.r1 * outer, low}, around);
  const std::vector<std::uint32_t> last = add_ring(solid, {cylinder.r2 * outer, high}, around);
  for (std::size_t i = 0; i < first.size(); ++i) solid.edges.push_back({first[i], last[i]});
  solid.faces.push_back({{{0, 0, -1}, low}, first});
  solid.faces.push_back({{{0, 0, 1}, -high}, last});
  return solid;
}

CurvedSurface curved_surface(const model::Primitive& primitive) {
  if (const auto* sphere = std::get_if<model::Sphere>(&primitive.shape))
    return make_surface(*sphere, primitive.transform);
  return make_surface(std::get<model::Cylinder>(primitive.shape), primitive.transform);
}

}  // namespace csgsim::facet
