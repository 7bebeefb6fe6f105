#include "sim/software/convert/ray_bundle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "sim/software/methods/counts.h"
#include "sim/software/traversals/status.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software::convert {

namespace {

/// A ray enters or leaves a body before the cell `z`.
struct Crossing {
  std::uint32_t x = 0;
  std::uint32_t z = 0;
  std::uint32_t body = 0;
};

/// A half-open range of cells.
struct Range {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

std::uint32_t clamped(double number, std::uint32_t maximum) {
  return static_cast<std::uint32_t>(std::clamp(number, 0.0, static_cast<double>(maximum)));
}

/// Cells whose centres lie between two coordinates.
Range cells_between(const CellGrid& grid, int axis, double low, double high) {
  return {clamped(std::ceil((low - grid.low[axis]) / grid.cell - 0.5), grid.resolution),
          clamped(std::floor((high - grid.low[axis]) / grid.cell - 0.5) + 1, grid.resolution)};
}

/// The rays of a row of cells.
class Row {
 public:
  Row(const Bodies& bodies, const CellGrid& grid) : bodies_(bodies), grid_(grid) {}

  void add(std::uint32_t body, std::uint32_t y) {
    const UnitBox& box = bodies_.bodies[body].box;
    const Range columns = cells_between(grid_, 0, box.low.x, box.high.x);
    for (std::uint32_t x = columns.first; x < columns.last; ++x) {
      const Range inside = cells_in(bodies_.bodies[body], grid_.middle(0, x), grid_.middle(1, y));
      if (inside.first >= inside.last) continue;
      events_.push_back({x, inside.first, body});
      events_.push_back({x, inside.last, body});
    }
  }

  /// Returns and removes the events of the row, sorted by column and depth.
  std::vector<Crossing> release() {
    std::ranges::sort(events_, {}, [](const Crossing& one) { return std::tuple(one.x, one.z, one.body); });
    return std::exchange(events_, {});
  }

 private:
  [[nodiscard]] Range cells_in(const Body& body, double x, double y) const {
    Range inside = cells_between(grid_, 2, body.box.low.z, body.box.high.z);
    for (const BodyFace& face : body.faces) {
      const std::array<double, 4>& near = bodies_.planes.coefficients(face.halfspace.plane);
      const double start = near[0] * x + near[1] * y + near[2] * grid_.middle(2, 0) + near[3];
      const double step = near[2] * grid_.cell;
      // A centre on the plane counts as in front of it, because the first component of the normal is positive.
      const bool keeps_before = !face.halfspace.positive;
      if (std::abs(step) < place_error / grid_.resolution) {
        if ((start > -place_error) != keeps_before) return {};
        continue;
      }
      const double crossing = (-place_error - start) / step;
      const std::uint32_t cell = clamped(std::ceil(crossing), grid_.resolution);
      if ((step > 0) == keeps_before) {
        inside.first = std::max(inside.first, cell);
      } else {
        inside.last = std::min(inside.last, cell);
      }
      if (inside.first >= inside.last) return {};
    }
    return inside;
  }

  const Bodies& bodies_;
  const CellGrid& grid_;
  std::vector<Crossing> events_;
};

}  // namespace

RayBundle::RayBundle(const model::Tree& tree, const Bodies& bodies, const CellGrid& grid, const Work& work)
    : resolution_(grid.resolution), first_{0} {
  std::vector<std::vector<std::uint32_t>> of_row(grid.resolution);
  for (std::uint32_t i = 0; i < bodies.bodies.size(); ++i) {
    const Range rows = cells_between(grid, 1, bodies.bodies[i].box.low.y, bodies.bodies[i].box.high.y);
    for (std::uint32_t y = rows.first; y < rows.last; ++y) of_row[y].push_back(i);
  }
  const software::Tree binary = make_tree(tree, Shape::balanced);
  UncountedMethod count;
  StatusTree<UncountedMethod> status(binary);
  Row row(bodies, grid);
  for (std::uint32_t y = 0; y < grid.resolution; ++y) {
    for (const std::uint32_t body : of_row[y]) {
      work.charge(bodies.bodies[body].faces.size() * grid.resolution, "converting the model to blocks");
      row.add(body, y);
    }
    const std::vector<Crossing> events = row.release();
    std::size_t at = 0;
    for (std::uint32_t x = 0; x < grid.resolution; ++x) {
      bool is_in = false;
      while (at < events.size() && events[at].x == x) {
        const std::uint32_t z = events[at].z;
        for (; at < events.size() && events[at].x == x && events[at].z == z; ++at) status.flip(events[at].body, count);
        if (status.evaluate(count) == is_in) continue;
        is_in = !is_in;
        changes_.push_back(static_cast<std::uint16_t>(z));
      }
      first_.push_back(changes_.size());
    }
  }
}

}  // namespace csgsim::software::convert
