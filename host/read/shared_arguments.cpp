#include "host/read/shared_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace csgsim::read {

namespace {

/// Lower limit of $fa and $fs in OpenSCAD.
constexpr double min_facet_control = 0.01;

}  // namespace

model::FacetControl read_facets(const Arguments& arguments) {
  model::FacetControl facets;
  facets.fn = arguments.number("$fn").value_or(facets.fn);
  facets.fa = std::max(arguments.number("$fa").value_or(facets.fa), min_facet_control);
  facets.fs = std::max(arguments.number("$fs").value_or(facets.fs), min_facet_control);
  return facets;
}

std::optional<double> read_radius(const Arguments& arguments, std::string_view radius, std::string_view diameter) {
  const std::optional<double> r = arguments.number(radius);
  const std::optional<double> d = arguments.number(diameter);
  if (r && d) arguments.fail("{} and {} are both given; remove one", radius, diameter);
  return d ? *d / 2 : r;
}

void IndexReader::warn(ValueView value, const std::string& message) {
  if (!has_warned_) arguments_.report(value, "warning: " + message + ", as in OpenSCAD");
  has_warned_ = true;
}

std::optional<std::uint32_t> IndexReader::read_index(ValueView value) {
  if (!value.is(ValueKind::number)) warn(value, "the index of a point is not a number; it counts as 0");
  const double number = value.is(ValueKind::number) ? value.value().number : 0;
  const double whole = std::trunc(number);
  if (!(whole >= 0 && whole < static_cast<double>(points_))) {
    warn(value, fmt::format("points[{}] does not exist; {}; the index is dropped", number,
                            points_ == 0 ? "there are no points"
                                         : fmt::format("there are points[0] to points[{}]", points_ - 1)));
    return std::nullopt;
  }
  const auto index = static_cast<std::uint32_t>(whole);
  if (whole != number)
    warn(value, fmt::format("the index of a point is {}, not a whole number; it counts as {}", number, index));
  return index;
}

std::vector<std::uint32_t> IndexReader::read(ValueView list) {
  std::vector<std::uint32_t> indices;
  if (!list.is(ValueKind::vector)) {
    warn(list, "this is not a vector of point indices; it is dropped");
    return indices;
  }
  list.for_each([&](ValueView value) {
    if (const std::optional<std::uint32_t> index = read_index(value)) indices.push_back(*index);
  });
  return indices;
}

}  // namespace csgsim::read
