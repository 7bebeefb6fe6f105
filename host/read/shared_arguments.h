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

// Arguments that several nodes have.

namespace csgsim::read {

/// $fn, $fa and $fs, as OpenSCAD bounds them.
model::FacetControl read_facets(const Arguments& arguments);

/// A radius that the file may give as a diameter.
std::optional<double> read_radius(const Arguments& arguments, std::string_view radius, std::string_view diameter);

/// Indices of points, as OpenSCAD 2021.01 reads them: it cuts a fraction off, takes what is no number for 0, and leaves
/// out an index of no point, and a list that is no vector. The user is warned of the first of each node.
class IndexReader {
 public:
  /// The node has `points` points.
  IndexReader(const Arguments& arguments, std::size_t points) : arguments_(arguments), points_(points) {}

  /// The indices of one face or path.
  std::vector<std::uint32_t> read(ValueView list);

  /// Warns of a value that is changed or left out, unless the node has had a warning.
  void warn(ValueView value, const std::string& message);

 private:
  std::optional<std::uint32_t> read_index(ValueView value);

  const Arguments& arguments_;
  std::size_t points_;
  bool has_warned_ = false;
};

/// The numbers of a vector of N; none where it is something else, or one of them is not finite.
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

/// The points of a node. None if one is no point: the user is told so, and of the `outcome`.
template <int N>
std::optional<std::vector<glm::vec<N, double>>> read_points(const Arguments& arguments, std::string_view node,
                                                            std::string_view outcome) {
  constexpr std::string_view form = N == 2 ? "[x, y]" : "[x, y, z]";
  const ValueView list = arguments.required("points", fmt::format("points = [{}, ...]", form));
  if (!list.is(ValueKind::vector)) arguments.fail(list, "points of {}() must be a vector of {}", node, form);
  std::vector<glm::vec<N, double>> points;
  std::optional<ValueView> bad;
  list.for_each([&](ValueView value) {
    const auto point = finite_numbers<N>(value);
    if (point) points.push_back(*point);
    if (!point && !bad) bad = value;
  });
  if (!bad) return points;
  arguments.tell(*bad, fmt::format("warning: a point of {}() is no {} of finite numbers; {}, as in OpenSCAD", node,
                                   form, outcome));
  return std::nullopt;
}

}  // namespace csgsim::read
