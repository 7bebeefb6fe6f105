#include "host/read/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace csgsim::read {

namespace {

/// A matrix is singular if the volume spanned by its normalized columns is below this: far above the rounding errors of
/// matrix products, and far below intentional flattening.
constexpr double singular_volume = 1e-12;

bool is_finite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) return false;
    }
  }
  return true;
}

}  // namespace

glm::dmat4 read_matrix(const Arguments& arguments) {
  const ValueView rows = arguments.required("m", "a 4x4 matrix by rows: [[1, 0, 0, x], [0, 1, 0, y], ...]");
  if (!rows.is(ValueKind::vector) || rows.size() < 3 || rows.size() > 4) {
    arguments.fail(rows, "the matrix of multmatrix() must be a vector of 4 rows");
  }
  glm::dmat4 matrix(1);
  int row = 0;
  rows.for_each([&](ValueView numbers) {
    std::array<double, 4> entries{matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]};
    arguments.read_numbers(numbers, 3, entries, "a row of the matrix");
    for (int column = 0; column < 4; ++column) matrix[column][row] = entries[static_cast<std::size_t>(column)];
    ++row;
  });
  if (!is_finite(matrix)) return glm::dmat4(std::numeric_limits<double>::quiet_NaN());
  if (matrix[0][3] != 0 || matrix[1][3] != 0 || matrix[2][3] != 0) {
    arguments.report(rows,
                     fmt::format("the first three numbers of the matrix's last row, {:g}, {:g}, {:g}, are ignored, "
                                 "as in OpenSCAD's rendering",
                                 matrix[0][3], matrix[1][3], matrix[2][3]));
    matrix[0][3] = matrix[1][3] = matrix[2][3] = 0;
  }
  return matrix[3][3] == 1 ? matrix : matrix / matrix[3][3];
}

bool is_degenerate(const glm::dmat4& matrix) {
  if (!is_finite(matrix)) return true;
  std::array<glm::dvec3, 3> columns{};
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 column(matrix[i]);
    const double length = std::hypot(column.x, column.y, column.z);
    if (length == 0 || !std::isfinite(length)) return true;
    columns[static_cast<std::size_t>(i)] = column / length;
  }
  return std::abs(glm::dot(columns[0], glm::cross(columns[1], columns[2]))) < singular_volume;
}

Colour read_colour(const Arguments& arguments) {
  const ValueView value = arguments.required("c", "[red, green, blue], each from 0 to 1");
  if (value.is(ValueKind::string)) {
    arguments.fail(value, "color() does not accept names; write [red, green, blue], each from 0 to 1");
  }
  std::array<double, 4> components{0, 0, 0, 1};
  arguments.read_numbers(value, 3, components, "the colour");
  components[3] = arguments.number("alpha").value_or(components[3]);
  Colour colour;
  const auto is_given = [](double component) { return component >= 0; };
  colour.is_whole = std::ranges::all_of(components, is_given);
  if (std::all_of(components.begin(), components.begin() + 3, is_given))
    colour.rgb = glm::min(glm::dvec3(components[0], components[1], components[2]), glm::dvec3(1));
  if (is_given(components[3])) colour.opacity = std::min(components[3], 1.0);
  return colour;
}

}  // namespace csgsim::read
