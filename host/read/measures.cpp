#include "host/read/measures.h"

#include <algorithm>

namespace csgsim::read {

namespace {

/// OpenSCAD raises $fa and $fs to this.
constexpr double least_facet_control = 0.01;

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

}  // namespace csgsim::read
