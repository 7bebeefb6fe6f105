#include "host/read/hulls.h"

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
#include "hw/base/error.h"

namespace csgsim::read {

namespace {

Made hull_of(Operands operands) {
  if (operands.solids.empty()) return {{}, flat::hull(operands.areas)};
  const model::Tree all = only_solid(std::move(operands));
  Made made;
  if (std::optional<model::Polyhedron> piece = solids::hull_piece(solids::vertices_of(all)))
    made.pieces.push_back(*std::move(piece));
  return made;
}

Made sum_of(const Operands& operands) {
  if (operands.solids.empty()) return {{}, flat::minkowski(operands.areas)};
  if (!operands.areas.empty()) throw InputError("it takes solids or 2-D children, not both");
  std::vector<solids::Pieces> all;
  for (const model::Tree& solid : operands.solids) all.push_back(solids::pieces_of(solid));
  return {solids::minkowski(all), {}};
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

Made resized(Operands operands, const NewSize& to) {
  if (operands.solids.empty()) {
    const flat::Area area = only_area(operands);
    return {{}, flat::resized(area, glm::dvec2(to.size), {to.automatic[0], to.automatic[1]})};
  }
  std::vector<model::Polyhedron> pieces = solids::pieces_of(only_solid(std::move(operands)));
  if (pieces.empty()) return {};
  glm::dvec3 low = pieces.front().points.front();
  glm::dvec3 high = low;
  for (const model::Polyhedron& piece : pieces) {
    for (const glm::dvec3& point : piece.points) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  const glm::dvec3 scale = solids::resize_scale(high - low, to.size, to.automatic);
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
    const model::Tree solid = only_solid(std::move(operands));
    return Made{{}, cut ? solids::section(solid) : solids::shadow(solids::pieces_of(solid))};
  };
}

}  // namespace csgsim::read
