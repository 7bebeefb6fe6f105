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

NodeResult make_hull(Operands operands) {
  if (operands.dimensions == 2) return {{}, flat::hull(operands.areas), {}, 2};
  if (operands.solids.empty()) return {};
  const Work work = operands.work;
  const model::Tree all = union_of_solids(std::move(operands));
  NodeResult made;
  if (std::optional<model::Polyhedron> piece = solids::hull_piece(solids::evaluate_vertices(all, work), work))
    made.pieces.push_back(*std::move(piece));
  return made;
}

NodeResult make_sum(const Operands& operands) {
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

/// The arguments of resize().
struct NewSize {
  glm::dvec3 size{0};
  std::array<bool, 3> automatic{};
};

/// The scale factors, about the origin, that resize() of OpenSCAD 2021.01 applies to a solid of the given size. Each
/// axis with a nonzero new size is scaled to it; other axes are not scaled or, if they are automatic, scaled like the
/// axis with the largest new size. No axis is scaled if the solid is flat along an axis with a new size.
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

/// Whether the solid is not the result of a Boolean.
bool is_single_solid(const model::Tree& solid) {
  return std::ranges::all_of(solid.nodes, [](const model::Node& node) { return node.is_leaf || node.of_pieces; });
}

NodeResult resized(Operands operands, NewSize to) {
  if (operands.dimensions == 2) {
    const flat::Area area = union_of_areas(operands);
    return {{},
            flat::resized(area, glm::dvec2(to.size), {to.automatic[0], to.automatic[1]}),
            {},
            has_area(operands) ? 2U : 0U};
  }
  if (operands.solids.empty()) return {};
  const Work work = operands.work;
  const model::Tree solid = union_of_solids(std::move(operands));
  std::vector<model::Polyhedron> pieces = solids::evaluate_pieces(solid, work);
  if (pieces.empty()) return {};
  facet::Box box;
  for (const model::Polyhedron& piece : pieces) box = facet::hull(box, facet::box_of(piece.points));
  // Negative new sizes are treated as 0 for a single solid, but mirror the result of a Boolean.
  if (is_single_solid(solid)) to.size = glm::max(to.size, glm::dvec3(0));
  const glm::dvec3 scale = scale_to(to, box.high - box.low);
  for (model::Polyhedron& piece : pieces) piece = scaled(std::move(piece), scale);
  return {std::move(pieces), {}};
}

/// Reads true, false, or a vector with one of these per axis.
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

Maker read_hull(const Arguments& /*arguments*/) { return make_hull; }

Maker read_minkowski(const Arguments& /*arguments*/) { return make_sum; }

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
    const model::Tree solid = union_of_solids(std::move(operands));
    const solids::Projection projection = cut ? solids::section(solid, work) : solids::shadow(solid, work);
    NodeResult made{{}, projection.area};
    if (projection.coarse_size > 0)
      made.warnings.push_back(
          fmt::format("an outline of size {:g} is rounded to {:.2g}, which is more than 1e-6 of its size, because "
                      "much larger outlines surround it; project it separately",
                      projection.coarse_size, projection.coarse_step));
    return made;
  };
}

}  // namespace csgsim::read
