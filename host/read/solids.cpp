#include "host/read/solids.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/read/polyhedron.h"

namespace csgsim::read {

namespace {

/// OpenSCAD raises $fa and $fs to this.
constexpr double least_facet_control = 0.01;

model::FacetControl read_facets(const Arguments& arguments) {
  model::FacetControl facets;
  facets.fn = arguments.number("$fn").value_or(facets.fn);
  facets.fa = std::max(arguments.number("$fa").value_or(facets.fa), least_facet_control);
  facets.fs = std::max(arguments.number("$fs").value_or(facets.fs), least_facet_control);
  return facets;
}

bool is_size(double value) { return value > 0 && std::isfinite(value); }
bool is_size_or_zero(double value) { return value == 0 || is_size(value); }

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

/// A radius that the file may give as a diameter.
std::optional<double> read_radius(const Arguments& arguments, std::string_view radius, std::string_view diameter) {
  const std::optional<double> r = arguments.number(radius);
  const std::optional<double> d = arguments.number(diameter);
  if (r && d) arguments.fail("{} and {} are both given; take one out", radius, diameter);
  return d ? *d / 2 : r;
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
  if (both && r1 && r2) arguments.fail("r, r1 and r2 are all given; take r out");
  if (!r1) r1 = both;
  if (!r2) r2 = both;
  if (!r1 || !r2) arguments.fail("cylinder() lacks its {}; add {} = radius", r1 ? "r2" : "r1", r1 ? "r2" : "r1");
  const bool center = arguments.boolean("center").value_or(false);
  const bool is_solid = is_size(height) && is_size_or_zero(*r1) && is_size_or_zero(*r2) && (*r1 > 0 || *r2 > 0);
  if (!is_solid) return std::nullopt;
  return model::Cylinder{height, *r1, *r2, center, facets};
}

}  // namespace

std::optional<model::Shape> read_solid(NodeKind kind, const Arguments& arguments) {
  switch (kind) {
    case NodeKind::cube: return read_cube(arguments);
    case NodeKind::sphere: return read_sphere(arguments);
    case NodeKind::cylinder: return read_cylinder(arguments);
    case NodeKind::polyhedron: return read_polyhedron(arguments);
    case NodeKind::unite:
    case NodeKind::subtract:
    case NodeKind::intersect:
    case NodeKind::transform:
    case NodeKind::colour:
    case NodeKind::unsupported:
    case NodeKind::source: break;
  }
  throw std::logic_error("a node that is no solid was read as one");
}

}  // namespace csgsim::read
