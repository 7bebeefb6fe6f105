#include "host/read/shared_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

void IndexReader::warn(ValueView value, const std::string& message) {
  if (!has_warned_) arguments_.tell(value, "warning: " + message + ", as in OpenSCAD");
  has_warned_ = true;
}

std::optional<std::uint32_t> IndexReader::read_index(ValueView value) {
  if (!value.is(ValueKind::number)) warn(value, "the index of a point is no number; it is taken for 0");
  const double number = value.is(ValueKind::number) ? value.value().number : 0;
  const double whole = std::trunc(number);
  if (!(whole >= 0 && whole < static_cast<double>(points_))) {
    warn(value,
         fmt::format("there is no points[{}]; {}; the index is left out", number,
                     points_ == 0 ? "there are none" : fmt::format("there are points[0] to points[{}]", points_ - 1)));
    return std::nullopt;
  }
  const auto index = static_cast<std::uint32_t>(whole);
  if (whole != number)
    warn(value, fmt::format("the index of a point is {}, not a whole number; it is taken for {}", number, index));
  return index;
}

std::vector<std::uint32_t> IndexReader::read(ValueView list) {
  std::vector<std::uint32_t> indices;
  if (!list.is(ValueKind::vector)) {
    warn(list, "this is no vector of indices of points; it is left out");
    return indices;
  }
  list.for_each([&](ValueView value) {
    if (const std::optional<std::uint32_t> index = read_index(value)) indices.push_back(*index);
  });
  return indices;
}

}  // namespace csgsim::read
