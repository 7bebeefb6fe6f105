#include "host/read/shared_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace csgsim::read {

namespace {

/// OpenSCAD raises $fa and $fs to this.
constexpr double least_facet_control = 0.01;

std::uint32_t read_index(const Arguments& arguments, ValueView value, std::size_t points) {
  const double number = arguments.read_number(value, "the index of a point");
  if (!(number >= 0 && number < static_cast<double>(points))) {
    arguments.fail(value, "there is no points[{}]; {}", number,
                   points == 0 ? "there are none" : fmt::format("there are points[0] to points[{}]", points - 1));
  }
  if (number != std::floor(number)) arguments.fail(value, "the index of a point must be a whole number");
  return static_cast<std::uint32_t>(number);
}

}  // namespace

model::FacetControl read_facets(const Arguments& arguments) {
  model::FacetControl facets;
  facets.fn = arguments.number("$fn").value_or(facets.fn);
  facets.fa = std::max(arguments.number("$fa").value_or(facets.fa), least_facet_control);
  facets.fs = std::max(arguments.number("$fs").value_or(facets.fs), least_facet_control);
  return facets;
}

std::optional<double> read_radius(const Arguments& arguments, std::string_view radius, std::string_view diameter) {
  const std::optional<double> r = arguments.number(radius);
  const std::optional<double> d = arguments.number(diameter);
  if (r && d) arguments.fail("{} and {} are both given; take one out", radius, diameter);
  return d ? *d / 2 : r;
}

std::vector<std::uint32_t> read_indices(const Arguments& arguments, ValueView list, std::size_t points) {
  if (!list.is(ValueKind::vector)) arguments.fail(list, "expected a vector of indices of points");
  std::vector<std::uint32_t> indices;
  list.for_each([&](ValueView value) { indices.push_back(read_index(arguments, value, points)); });
  return indices;
}

}  // namespace csgsim::read
