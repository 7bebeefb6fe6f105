#include "host/swept/net.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "host/swept/curve.h"
#include "host/swept/flat.h"
#include "host/swept/subdivision.h"

namespace csgsim::swept {

namespace {

/// Bernstein coefficients of a patch: rows along u, stacked along v.
using Grid = std::array<Segment, 4>;

Segment cubic(const std::array<glm::dvec3, 4>& coefficients) { return {3, coefficients}; }

/// The piece of a uniform cubic B-spline with these four control points.
Segment bernstein(const std::array<glm::dvec3, 4>& p) {
  return cubic({(p[0] + 4.0 * p[1] + p[2]) / 6.0, (2.0 * p[1] + p[2]) / 3.0, (p[1] + 2.0 * p[2]) / 3.0,
                (p[1] + 4.0 * p[2] + p[3]) / 6.0});
}

Grid turned(const Grid& grid) {
  Grid columns;
  for (std::size_t i = 0; i < 4; ++i)
    columns[i] =
        cubic({grid[0].coefficients[i], grid[1].coefficients[i], grid[2].coefficients[i], grid[3].coefficients[i]});
  return columns;
}

/// The west and east halves.
std::array<Grid, 2> halves(const Grid& grid) {
  std::array<Grid, 2> parts{grid, grid};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [west, east] = swept::halves(grid[i]);
    parts[0][i] = west;
    parts[1][i] = east;
  }
  return parts;
}

glm::dvec3 middle(const Grid& grid) {
  std::array<glm::dvec3, 4> column{};
  for (std::size_t i = 0; i < 4; ++i) column[i] = at(grid[i], 0.5);
  return at(cubic(column), 0.5);
}

/// Whether a cubic is close to the line between its ends: its distance from the line is at most 3/4 of that of its
/// inner coefficients.
bool is_straight(const Segment& side, double tolerance, SubdivisionCounts& counts) {
  counts.tests += 2;
  for (int i = 0; i < 2; ++i) counts.arithmetic += line_arithmetic;
  return 0.75 * std::max(distance_to_segment(side.coefficients[1], side.first(), side.last()),
                         distance_to_segment(side.coefficients[2], side.first(), side.last())) <=
         tolerance;
}

/// Additions and halvings of coordinates when one cubic is halved: six intermediate points with three coordinates each.
constexpr std::uint64_t cubic_halves = 2 * 3 * 6;

struct GridShape {
  using Part = Grid;

  static std::array<glm::dvec3, 4> corners(const Grid& grid) {
    return {grid[0].first(), grid[0].last(), grid[3].first(), grid[3].last()};
  }

  static bool is_flat(const Grid& grid, const std::array<glm::dvec3, 4>& corners, const Accuracy& accuracy,
                      SubdivisionCounts& counts) {
    ++counts.points;
    counts.arithmetic.adds += 5 * cubic_halves;
    if (!swept::is_flat(corners, middle(grid), accuracy.tolerance, counts)) return false;
    if (accuracy.flatness == Flatness::plane) return true;
    const Grid columns = turned(grid);
    return is_straight(grid[0], accuracy.tolerance, counts) && is_straight(grid[3], accuracy.tolerance, counts) &&
           is_straight(columns[0], accuracy.tolerance, counts) && is_straight(columns[3], accuracy.tolerance, counts);
  }

  static std::array<Grid, 4> parts(const Grid& grid, SubdivisionCounts& counts) {
    counts.halvings += 3;
    counts.arithmetic.adds += 3 * 4 * cubic_halves;
    const auto [south, north] = halves(turned(grid));
    const auto [south_west, south_east] = halves(turned(south));
    const auto [north_west, north_east] = halves(turned(north));
    return {south_west, south_east, north_west, north_east};
  }
};

class NetSurface : public Surface {
 public:
  explicit NetSurface(const Net& net) : columns_(net.rows.front().size() - 3), rows_(net.rows.size() - 3) {
    for (std::size_t row = 0; row < rows_; ++row) {
      for (std::size_t column = 0; column < columns_; ++column) grids_.push_back(grid(net, column, row));
    }
  }

  [[nodiscard]] std::size_t columns() const override { return columns_; }
  [[nodiscard]] std::size_t rows() const override { return rows_; }

  std::unique_ptr<Stream> subdivide(std::size_t column, std::size_t row, const Accuracy& accuracy,
                                    SubdivisionCounts& counts) override {
    return std::make_unique<Subdivision<GridShape>>(shape_, grids_[row * columns_ + column], accuracy, counts);
  }

 private:
  static Grid grid(const Net& net, std::size_t column, std::size_t row) {
    Grid along;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::vector<glm::dvec3>& points = net.rows[row + i];
      along[i] = bernstein({points[column], points[column + 1], points[column + 2], points[column + 3]});
    }
    Grid columns = turned(along);
    for (Segment& one : columns) one = bernstein(one.coefficients);
    return turned(columns);
  }

  std::size_t columns_;
  std::size_t rows_;
  std::vector<Grid> grids_;
  GridShape shape_;
};

}  // namespace

std::string validation_error(const Net& net) {
  if (net.rows.size() < 4) return fmt::format("a patch needs at least 4 rows of points, not {}", net.rows.size());
  for (const std::vector<glm::dvec3>& row : net.rows) {
    if (row.size() < 4) return fmt::format("a row of a patch needs at least 4 points, not {}", row.size());
    if (row.size() != net.rows.front().size())
      return fmt::format("rows of a patch have {} and {} points; make them equally long", net.rows.front().size(),
                         row.size());
  }
  if ((net.rows.size() - 3) * (net.rows.front().size() - 3) > max_patches)
    return fmt::format("more than {} patches; remove points", max_patches);
  return "";
}

std::unique_ptr<Surface> make_surface(const Net& net) { return std::make_unique<NetSurface>(net); }

}  // namespace csgsim::swept
