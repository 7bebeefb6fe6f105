// Arguments common to several nodes: facets, radii, points, indices.
// Used throughout host/read.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/model/tree.h"
#include "host/read/arguments.h"

namespace csgsim::read {

/// $fn, $fa and $fs, limited as in OpenSCAD.
model::FacetControl read_facets(const Arguments& arguments);

/// A radius, which the file may give as a diameter; empty if it gives neither.
std::optional<double> read_radius(const Arguments& arguments, std::string_view radius, std::string_view diameter);

/// Reads point indices as OpenSCAD 2021.01 does: fractions are truncated, values that are not numbers are read as 0,
/// and indices out of range and lists that are not vectors are dropped. Only the first such case in each node causes a
/// warning.
class IndexReader {
 public:
  /// `point_count`: number of points of the node; indices must be below it.
  IndexReader(const Arguments& arguments, std::size_t point_count) : arguments_(arguments), points_(point_count) {}

  /// The indices of one face or path.
  std::vector<std::uint32_t> read(ValueView list);

  /// Warns about a value that is changed or dropped, unless the node has already caused a warning.
  void warn(ValueView value, const std::string& message);

 private:
  std::optional<std::uint32_t> read_index(ValueView value);

  const Arguments& arguments_;
  std::size_t points_;
  bool has_warned_ = false;
};

/// The numbers of a vector with N elements. Empty if the value is anything else or an element is not finite.
template <int N>
std::optional<glm::vec<N, double>> finite_numbers(ValueView vector) {
  if (!vector.is(ValueKind::vector) || vector.size() != N) return std::nullopt;
  glm::vec<N, double> numbers(0);
  int next = 0;
  bool all_finite = true;
  vector.for_each([&](ValueView element) {
    const double number = element.value().number;
    all_finite = all_finite && element.is(ValueKind::number) && std::isfinite(number);
    numbers[next++] = number;
  });
  return all_finite ? std::optional(numbers) : std::nullopt;
}

/// The points of a node. Empty if a value is not a point; a warning then names the value and the `consequence`.
template <int N>
std::optional<std::vector<glm::vec<N, double>>> read_points(const Arguments& arguments, std::string_view node_name,
                                                            std::string_view consequence) {
  constexpr std::string_view form = N == 2 ? "[x, y]" : "[x, y, z]";
  const ValueView list = arguments.required("points", fmt::format("points = [{}, ...]", form));
  if (!list.is(ValueKind::vector)) arguments.fail(list, "points of {}() must be a vector of {}", node_name, form);
  std::vector<glm::vec<N, double>> points;
  std::optional<ValueView> bad;
  list.for_each([&](ValueView value) {
    const auto point = finite_numbers<N>(value);
    if (point) points.push_back(*point);
    if (!point && !bad) bad = value;
  });
  if (!bad) return points;
  arguments.report(*bad, fmt::format("warning: a point of {}() is not {} of finite numbers; {}, as in OpenSCAD",
                                     node_name, form, consequence));
  return std::nullopt;
}

}  // namespace csgsim::read
