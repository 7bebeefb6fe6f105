#include "host/read/hulls.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "host/flat/hull.h"
#include "host/flat/minkowski.h"
#include "host/flat/place.h"
#include "host/read/only.h"
#include "host/solids/evaluate.h"
#include "host/solids/hull.h"
#include "host/solids/minkowski.h"
#include "host/solids/projection.h"
#include "host/solids/resize.h"

namespace csgsim::read {

namespace {

Made hull_of(Operands operands) {
  if (operands.dimensions == 2) return {{}, flat::hull(operands.areas), {}, 2};
  if (operands.solids.empty()) return {};
  const Work work = operands.work;
  const model::Tree all = only_solid(std::move(operands));
  Made made;
  if (std::optional<model::Polyhedron> piece = solids::hull_piece(solids::vertices_of(all, work), work))
    made.pieces.push_back(*std::move(piece));
  return made;
}

Made sum_of(const Operands& operands) {
  if (operands.dimensions == 2)
    return {{}, flat::minkowski(operands.areas, operands.work), {}, has_area(operands) ? 2U : 0U};
  if (operands.solids.empty()) return {};
  std::vector<solids::Pieces> all;
  for (const model::Tree& solid : operands.solids) all.push_back(solids::pieces_of(solid, operands.work));
  return {solids::minkowski(all, operands.work), {}};
}

model::Polyhedron scaled(model::Polyhedron piece, const glm::dvec3& scale) {
  for (glm::dvec3& point : piece.points) point *= scale;
  for (glm::dvec4& plane : piece.planes) {
    const glm::dvec3 normal = glm::dvec3(plane) / scale;
    const double length = glm::length(normal);
    plane = {normal / length, plane.w / length};
  }
  return piece;
}

struct NewSize {
  glm::dvec3 size{0};
  std::array<bool, 3> automatic{};
};

/// Whether no Boolean has made it.
bool is_one(const model::Tree& solid) {
  return std::ranges::all_of(solid.nodes, [](const model::Node& node) { return node.is_leaf || node.of_pieces; });
}

Made resized(Operands operands, const NewSize& to) {
  if (operands.dimensions == 2) {
    const flat::Area area = only_area(operands);
    return {{},
            flat::resized(area, glm::dvec2(to.size), {to.automatic[0], to.automatic[1]}),
            {},
            has_area(operands) ? 2U : 0U};
  }
  if (operands.solids.empty()) return {};
  const Work work = operands.work;
  const model::Tree solid = only_solid(std::move(operands));
  std::vector<model::Polyhedron> pieces = solids::pieces_of(solid, work);
  if (pieces.empty()) return {};
  glm::dvec3 low = pieces.front().points.front();
  glm::dvec3 high = low;
  for (const model::Polyhedron& piece : pieces) {
    for (const glm::dvec3& point : piece.points) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  const glm::dvec3 scale = solids::resize_scale(high - low, to.size, to.automatic,
                                                is_one(solid) ? solids::Resized::one : solids::Resized::combined);
  for (model::Polyhedron& piece : pieces) piece = scaled(std::move(piece), scale);
  return {std::move(pieces), {}};
}

/// true, false, or one of them an axis.
std::array<bool, 3> read_automatic(const Arguments& arguments) {
  std::array<bool, 3> automatic{};
  const std::optional<ValueView> value = arguments.find("auto");
  if (!value) return automatic;
  if (!value->is(ValueKind::vector)) {
    automatic.fill(value->value().number != 0);
    return automatic;
  }
  std::size_t axis = 0;
  value->for_each([&](ValueView one) {
    if (axis < automatic.size()) automatic[axis++] = one.value().number != 0;
  });
  return automatic;
}

}  // namespace

Maker read_hull(const Arguments& /*arguments*/) { return hull_of; }

Maker read_minkowski(const Arguments& /*arguments*/) { return sum_of; }

Maker read_resize(const Arguments& arguments) {
  NewSize to;
  if (const std::optional<ValueView> size = arguments.find("newsize")) {
    std::array<double, 3> all{};
    arguments.read_numbers(*size, 2, all, "newsize");
    to.size = {all[0], all[1], all[2]};
  }
  to.automatic = read_automatic(arguments);
  return [to](Operands operands) { return resized(std::move(operands), to); };
}

Maker read_projection(const Arguments& arguments) {
  const bool cut = arguments.boolean("cut").value_or(false);
  return [cut](Operands operands) {
    const Work work = operands.work;
    const model::Tree solid = only_solid(std::move(operands));
    return Made{{}, cut ? solids::section(solid, work) : solids::shadow(solids::pieces_of(solid, work), work)};
  };
}

}  // namespace csgsim::read
