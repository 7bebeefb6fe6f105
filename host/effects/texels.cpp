#include "host/effects/texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/emit/facet_geometry.h"
#include "host/view/projection.h"

namespace csgsim::effects {

namespace {

/// Distance from a facet's rim, as a fraction of a texel, within which no line is drawn: the face ends at the texel's
/// boundary except for rounding.
constexpr double rim = 1e-6;

/// Tolerance for equal components of a normal.
constexpr double same_component = 1e-9;

/// More fraction bits would leave no room for the integer part.
constexpr unsigned max_texel_fraction_bits = 50;

/// The point where the ray of a pixel meets a plane: a point in model space as a linear function of column and row,
/// divided by another linear function.
struct PlanePoint {
  std::array<view::RealLinear, 3> numerators;
  view::RealLinear denominator;
};

view::RealLinear along(const glm::dvec3& per_column, const glm::dvec3& per_row, const glm::dvec3& at_centre,
                       const glm::dvec3& direction) {
  return {glm::dot(per_column, direction), glm::dot(per_row, direction), glm::dot(at_centre, direction)};
}

view::RealLinear sum(const view::RealLinear& one, double factor, const view::RealLinear& other) {
  return {one.a + factor * other.a, one.b + factor * other.b, one.at_centre + factor * other.at_centre};
}

glm::dvec3 axis(int number) { return {number == 0 ? 1.0 : 0.0, number == 1 ? 1.0 : 0.0, number == 2 ? 1.0 : 0.0}; }

/// The point of the plane normal . (p - place) = 0.
PlanePoint plane_point(const view::EyeSpace& space, const view::Sampling& sampling, const glm::dvec3& normal,
                       const glm::dvec3& place) {
  const glm::dvec3 per_column = space.axes.right * space.pixel;
  const glm::dvec3 per_row = -space.axes.up * space.pixel;
  const glm::dvec2 centre((sampling.width - 1.0) / 2.0 - space.middle_x,
                          (sampling.height - 1.0) / 2.0 - space.middle_y);
  const glm::dvec3 aside = per_column * centre.x + per_row * centre.y;
  const double to_plane = glm::dot(normal, place - space.eye);
  PlanePoint point;
  if (space.perspective) {
    // The point is eye + t * ray with 1 / t = normal . ray / to_plane.
    const view::RealLinear across = along(per_column, per_row, space.axes.forward + aside, normal);
    point.denominator = {across.a / to_plane, across.b / to_plane, across.at_centre / to_plane};
    for (int i = 0; i < 3; ++i) {
      point.numerators[static_cast<std::size_t>(i)] =
          sum(along(per_column, per_row, space.axes.forward + aside, axis(i)), space.eye[i], point.denominator);
    }
    return point;
  }
  // The start of the ray, moved along the view axis to the plane.
  const double steepness = glm::dot(normal, space.axes.forward);
  const auto moved = [&](const glm::dvec3& by, double distance) {
    return by + space.axes.forward * ((distance - glm::dot(normal, by)) / steepness);
  };
  const glm::dvec3 column = moved(per_column, 0);
  const glm::dvec3 row = moved(per_row, 0);
  const glm::dvec3 at_centre = space.eye + moved(aside, to_plane);
  point.denominator = {0, 0, 1};
  for (int i = 0; i < 3; ++i) point.numerators[static_cast<std::size_t>(i)] = along(column, row, at_centre, axis(i));
  return point;
}

/// The model axis most nearly perpendicular to the facet.
int axis_across(const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const double most = std::max({size.x, size.y, size.z}) - same_component;
  return size.x >= most ? 0 : size.y >= most ? 1 : 2;
}

/// Minimum number of fraction bits that limits the error of a boundary to boundary_error. `slope` is the growth of the
/// coordinate per column or per row, whichever is greater.
unsigned fraction_bits(double slope, const view::Sampling& sampling) {
  // view::to_fixed has an error of (1 + dx + dy) * 2^-(bits + 1), which is greatest in a corner.
  const double units = (static_cast<double>(sampling.width) + sampling.height) / 4 / (boundary_error * slope);
  int bits = 0;
  std::frexp(units, &bits);
  return static_cast<unsigned>(std::max(bits, 0));
}

double first_number(const TexelCoordinate& coordinate) { return std::floor(coordinate.least + rim); }

}  // namespace

TexelCoordinates texel_coordinates(const emit::Context& context, const emit::Facet& facet, const TexelGrid& grid) {
  const facet::Plane& plane = context.geometry.planes.planes()[facet.halfspace.plane];
  const glm::dvec3 place = context.geometry.planes.centre() - plane.normal * plane.offset;
  const PlanePoint point = plane_point(view::eye_space(context.view.camera, context.view.sampling),
                                       context.view.sampling, plane.normal, place);
  const std::vector<glm::dvec3> vertices = emit::facet_vertices(context, facet);
  const int across = axis_across(plane.normal);
  const auto coordinate = [&](int number, double corner) {
    const view::RealLinear moved = sum(point.numerators[static_cast<std::size_t>(number)], -corner, point.denominator);
    TexelCoordinate result{
        {moved.a / grid.size, moved.b / grid.size, moved.at_centre / grid.size}, point.denominator, 0, 0};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const double texels = (vertices[i][number] - corner) / grid.size;
      result.least = i == 0 ? texels : std::min(result.least, texels);
      result.most = i == 0 ? texels : std::max(result.most, texels);
    }
    return result;
  };
  return {coordinate(across == 0 ? 1 : 0, grid.corner.x), coordinate(across == 2 ? 1 : 2, grid.corner.y)};
}

double count_lines(const TexelCoordinate& coordinate) {
  return std::max(0.0, std::ceil(coordinate.most - rim) - 1 - first_number(coordinate));
}

std::optional<TexelLines> texel_lines(const TexelCoordinate& coordinate, const view::Sampling& sampling) {
  const auto first = view::to_fixed(first_number(coordinate), 0);
  if (!first) return std::nullopt;
  TexelLines all{*first, {}};
  const double count = count_lines(coordinate);
  for (std::int64_t i = 1; static_cast<double>(i) <= count; ++i) {
    const std::int64_t number = *first + i;
    const view::RealLinear real = sum(coordinate.numerator, -static_cast<double>(number), coordinate.denominator);
    const double slope = std::max(std::abs(real.a), std::abs(real.b));
    TexelLine line{number, std::nullopt, real.at_centre >= 0};
    if (slope > 0) {
      line.line = view::to_fixed({real.a / slope, real.b / slope, real.at_centre / slope}, fraction_bits(1, sampling),
                                 sampling.width, sampling.height);
    }
    all.lines.push_back(line);
  }
  return all;
}

std::optional<PeriodicCoordinate> periodic(const TexelCoordinate& coordinate, unsigned bits,
                                           const view::Sampling& sampling) {
  const view::RealLinear& linear = coordinate.numerator;
  const unsigned fraction = fraction_bits(std::max(std::abs(linear.a), std::abs(linear.b)), sampling);
  if (fraction > max_texel_fraction_bits) return std::nullopt;
  const double period = std::ldexp(1.0, static_cast<int>(bits));
  const double at_centre = linear.at_centre - period * std::floor(linear.at_centre / period);
  const auto fixed = view::to_fixed({linear.a, linear.b, at_centre}, fraction, sampling.width, sampling.height);
  if (!fixed) return std::nullopt;
  return PeriodicCoordinate{*fixed, fraction};
}

}  // namespace csgsim::effects
