#include "host/facet/covered_ball.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "host/model/degrees.h"
#include "hw/base/error.h"

namespace csgsim::facet {

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::uint64_t max_planes = 4'000'000;

/// A band of latitude between two polar angles, divided into equal cells around the axis. Angles are in radians.
struct Row {
  double middle = 0;
  std::uint64_t cells = 0;  ///< 0 if no number of cells suffices
};

/// The number of cells in a row for which the corners of a cell are within theta of its centre, by the cosine rule on
/// the sphere for the widest half-cell.
Row make_row(double first, double last, double theta) {
  const double middle = (first + last) / 2.0;
  double widest = pi;
  for (const double edge : {first, last}) {
    const double cosine = (std::cos(theta) - std::cos(middle) * std::cos(edge)) / (std::sin(middle) * std::sin(edge));
    if (cosine >= 1.0) return {middle, 0};
    if (cosine > -1.0) widest = std::min(widest, std::acos(cosine));
  }
  return {middle, std::max<std::uint64_t>(3, static_cast<std::uint64_t>(std::ceil(pi / widest * (1.0 - 1e-12))))};
}

/// Rows between two polar caps of radius theta; empty if `count` rows are too few.
std::vector<Row> make_rows(std::uint64_t count, double theta) {
  std::vector<Row> rows;
  const double height = (pi - 2.0 * theta) / static_cast<double>(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    rows.push_back(
        make_row(theta + static_cast<double>(i) * height, theta + static_cast<double>(i + 1) * height, theta));
    if (rows.back().cells == 0) return {};
  }
  return rows;
}

std::uint64_t count_cells(const std::vector<Row>& rows) {
  std::uint64_t cells = 0;
  for (const Row& row : rows) cells += row.cells;
  return rows.empty() ? std::numeric_limits<std::uint64_t>::max() : cells;
}

/// The division into rows that has the fewest cells. Rows of height 2 theta would have cells of no width. The minimum
/// is at a row height of about sqrt(2) theta, and never at more than double that number of rows.
std::vector<Row> fewest_cells(double theta) {
  const auto least = std::max<std::uint64_t>(1, static_cast<std::uint64_t>((pi - 2.0 * theta) / (2.0 * theta)));
  std::vector<Row> best;
  for (std::uint64_t count = least; count <= 2 * least + 2; ++count) {
    std::vector<Row> rows = make_rows(count, theta);
    if (count_cells(rows) < count_cells(best)) best = std::move(rows);
  }
  return best;
}

/// Adds meridians and parallels of a hull that contains a ball of the given radius.
void add_hull(Solid& solid, double radius) {
  constexpr std::uint32_t meridians = 48;
  constexpr std::uint32_t parallels = 24;
  // Offset by half a mesh in both directions, so that no face of the hull is closer to the centre than the radius.
  const double outer = radius / (model::cos_degrees(180.0 / meridians) * model::cos_degrees(90.0 / parallels));
  for (std::uint32_t row = 0; row <= parallels; ++row) {
    const double polar = 180.0 * row / parallels;
    for (std::uint32_t i = 0; i < meridians; ++i) {
      const double around = 360.0 * i / meridians;
      const auto index = static_cast<std::uint32_t>(solid.vertices.size());
      solid.vertices.emplace_back(outer * model::sin_degrees(polar) * model::cos_degrees(around),
                                  outer * model::sin_degrees(polar) * model::sin_degrees(around),
                                  outer * model::cos_degrees(polar));
      solid.edges.push_back({index, row * meridians + (i + 1) % meridians});
      if (row > 0) solid.edges.push_back({index - meridians, index});
    }
  }
}

}  // namespace

Solid covered_ball(double radius, double tolerance) {
  const double inner = std::max(radius - tolerance, radius * 0.5);
  const double theta = std::acos(inner / radius);
  if (2.0 * pi / (theta * theta) > static_cast<double>(max_planes)) {
    throw InputError("more than " + std::to_string(max_planes) + " facets in one sphere; raise the tolerance");
  }
  Solid solid;
  solid.faces.push_back({{{0, 0, 1}, -inner}, {}});
  for (const Row& row : fewest_cells(theta)) {
    for (std::uint64_t i = 0; i < row.cells; ++i) {
      const double around = 360.0 * static_cast<double>(i) / static_cast<double>(row.cells);
      const glm::dvec3 normal(std::sin(row.middle) * model::cos_degrees(around),
                              std::sin(row.middle) * model::sin_degrees(around), std::cos(row.middle));
      solid.faces.push_back({{normal, -inner}, {}});
    }
  }
  solid.faces.push_back({{{0, 0, -1}, -inner}, {}});
  add_hull(solid, radius);
  return solid;
}

}  // namespace csgsim::facet
