#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "host/facet/geometry.h"
#include "host/flat/hull.h"
#include "host/flat/minkowski.h"
#include "host/flat/place.h"
#include "host/read/node_readers.h"
#include "host/solids/evaluate.h"
#include "host/solids/hull.h"
#include "host/solids/minkowski.h"
#include "host/solids/projection.h"

namespace csgsim::read {

namespace {

Made hull_of(Operands operands) {
  if (operands.dimensions == 2) return {{}, flat::hull(operands.areas), {}, 2};
  if (operands.solids.empty()) return {};
  const Work work = operands.work;
  const model::Tree all = only_solid(std::move(operands));
  Made made;
  if (std::optional<model::Polyhedron> piece = solids::hull_piece(solids::evaluate_vertices(all, work), work))
    made.pieces.push_back(*std::move(piece));
  return made;
}

Made sum_of(const Operands& operands) {
  if (operands.dimensions == 2)
    return {{}, flat::minkowski(operands.areas, operands.work), {}, has_area(operands) ? 2U : 0U};
  if (operands.solids.empty()) return {};
  std::vector<solids::Pieces> all;
  for (const model::Tree& solid : operands.solids) all.push_back(solids::evaluate_pieces(solid, operands.work));
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

/// What resize() is given.
struct NewSize {
  glm::dvec3 size{0};
  std::array<bool, 3> automatic{};
};

/// How resize() of OpenSCAD 2021.01 scales a solid of that size about the origin: to each new size that is not 0; other
/// axes not at all, or, if they are automatic, as much as the axis of the largest new size. Not at all if the solid is
/// flat along an axis that has a new size.
glm::dvec3 scale_to(const NewSize& to, const glm::dvec3& size) {
  glm::dvec3 scale(1);
  int largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (to.size[axis] == 0) continue;
    if (size[axis] == 0) return glm::dvec3(1);
    scale[axis] = to.size[axis] / size[axis];
    if (to.size[axis] > to.size[largest]) largest = axis;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (to.automatic[static_cast<std::size_t>(axis)] && to.size[axis] == 0) scale[axis] = scale[largest];
  }
  return scale;
}

/// Whether no Boolean has made it.
bool is_one(const model::Tree& solid) {
  return std::ranges::all_of(solid.nodes, [](const model::Node& node) { return node.is_leaf || node.of_pieces; });
}

Made resized(Operands operands, NewSize to) {
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
  std::vector<model::Polyhedron> pieces = solids::evaluate_pieces(solid, work);
  if (pieces.empty()) return {};
  facet::Box box;
  for (const model::Polyhedron& piece : pieces) box = facet::hull(box, facet::box_of(piece.points));
  // New sizes below 0 count as 0 for a solid by itself; what a Boolean has made is mirrored by them.
  if (is_one(solid)) to.size = glm::max(to.size, glm::dvec3(0));
  const glm::dvec3 scale = scale_to(to, box.high - box.low);
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
    const solids::Projection projection = cut ? solids::section(solid, work) : solids::shadow(solid, work);
    Made made{{}, projection.area};
    if (projection.coarse_size > 0)
      made.warnings.push_back(
          fmt::format("an outline {:g} long is rounded to {:.2g}, which is more than 1e-6 of it, since much larger "
                      "ones reach around "
                      "it; project it alone",
                      projection.coarse_size, projection.coarse_step));
    return made;
  };
}

}  // namespace csgsim::read
