#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "host/model/tree.h"
#include "host/read/arguments.h"
#include "host/read/nodes.h"
#include "host/read/shared_arguments.h"

namespace csgsim::read {

namespace {

using namespace std::string_view_literals;

bool is_size(double value) { return value > 0 && std::isfinite(value); }
bool is_size_or_zero(double value) { return value == 0 || is_size(value); }

// The readers return nothing if the solid is empty.

std::optional<model::Shape> read_cube(const Arguments& arguments) {
  const ValueView size = arguments.required("size", "size = [x, y, z]");
  std::array<double, 3> sides{};
  if (size.is(ValueKind::number)) {
    sides.fill(size.value().number);
  } else {
    arguments.read_numbers(size, 3, sides, "size");
  }
  const bool center = arguments.boolean("center").value_or(false);
  if (!std::ranges::all_of(sides, is_size)) return std::nullopt;
  return model::Cube{{sides[0], sides[1], sides[2]}, center};
}

std::optional<model::Shape> read_sphere(const Arguments& arguments) {
  const model::FacetControl facets = read_facets(arguments);
  const std::optional<double> radius = read_radius(arguments, "r", "d");
  if (!radius) arguments.fail("sphere() lacks its r; add r = radius");
  if (!is_size(*radius)) return std::nullopt;
  return model::Sphere{*radius, facets};
}

std::optional<model::Shape> read_cylinder(const Arguments& arguments) {
  const model::FacetControl facets = read_facets(arguments);
  const double height = arguments.read_number(arguments.required("h", "h = height"), "h");
  const std::optional<double> both = read_radius(arguments, "r", "d");
  std::optional<double> r1 = read_radius(arguments, "r1", "d1");
  std::optional<double> r2 = read_radius(arguments, "r2", "d2");
  if (both && r1 && r2) arguments.fail("r, r1 and r2 are all given; remove r");
  if (!r1) r1 = both;
  if (!r2) r2 = both;
  if (!r1 || !r2) arguments.fail("cylinder() lacks its {}; add {} = radius", r1 ? "r2" : "r1", r1 ? "r2" : "r1");
  const bool center = arguments.boolean("center").value_or(false);
  const bool is_solid = is_size(height) && is_size_or_zero(*r1) && is_size_or_zero(*r2) && (*r1 > 0 || *r2 > 0);
  if (!is_solid) return std::nullopt;
  return model::Cylinder{height, *r1, *r2, center, facets};
}

constexpr std::array cube_parameters{"size"sv, "center"sv};
constexpr std::array sphere_parameters{"r"sv, "d"sv, "$fn"sv, "$fa"sv, "$fs"sv};
constexpr std::array cylinder_parameters{"h"sv,  "r1"sv, "r2"sv,  "center"sv, "r"sv,  "d"sv,
                                         "d1"sv, "d2"sv, "$fn"sv, "$fa"sv,    "$fs"sv};

constexpr std::array solid_rows{
    NodeType{"cube", NodeKind::solid, cube_parameters, 2, solid_extras, read_cube},
    NodeType{"sphere", NodeKind::solid, sphere_parameters, 1, common_extras, read_sphere},
    NodeType{"cylinder", NodeKind::solid, cylinder_parameters, 4, common_extras, read_cylinder},
};

}  // namespace

std::span<const NodeType> solid_node_types() { return solid_rows; }

}  // namespace csgsim::read
