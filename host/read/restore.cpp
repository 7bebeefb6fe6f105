#include "host/read/restore.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "host/model/degrees.h"
#include "host/model/hypotenuse.h"
#include "host/read/number.h"

namespace csgsim::read {

namespace {

/// Maximum error that the rounding of sines and their products causes in an entry of a rotation. It also applies to
/// zeros, which files contain as 6.12323e-17.
constexpr double noise = 1e-15;

double to_digits(double number, int digits) { return *parse_number(fmt::format("{:.{}g}", number, digits)); }

/// Whether a number that is known to within `error` may have been written with the six digits of `written`.
bool is_written_as(double number, double written, double error) {
  return to_digits(number - error, 6) <= written && written <= to_digits(number + error, 6);
}

bool is_written_as(const glm::dmat3& matrix, const glm::dmat3& written, double error) {
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!is_written_as(matrix[column][row], written[column][row], error)) return false;
    }
  }
  return true;
}

bool is_finite(const glm::dmat3& matrix) {
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!std::isfinite(matrix[column][row])) return false;
    }
  }
  return true;
}

/// Angle in hundredths of a degree; 0 if both entries are only rounding errors.
int angle(double sine, double cosine) {
  if (std::abs(sine) <= noise && std::abs(cosine) <= noise) return 0;
  return static_cast<int>(std::round(std::atan2(sine, cosine) * (18000.0 / std::numbers::pi)));
}

/// The angles of the rotation nearest to the matrix, in hundredths of a degree. If y is a right angle, x and z rotate
/// about the same axis, and x is set to 0.
glm::ivec3 euler_angles(const glm::dmat3& matrix) {
  const int y = angle(-matrix[0][2], model::hypotenuse(matrix[0][0], matrix[0][1]));
  if (std::abs(y) == 9000) return {0, y, angle(-matrix[1][0], matrix[1][1])};
  return {angle(matrix[1][2], matrix[2][2]), y, angle(matrix[0][1], matrix[0][0])};
}

/// The rotation about x, then y, then z by angles in hundredths of a degree. The error of an entry is at most 7e-16:
/// each sine and cosine is rounded once (a relative error of u = 2^-53), and so are products and sums. In c c' s + s'
/// s'', whose two products sum to at most 1, the errors are at most 5 u of the first product, 3 u of the second, and u
/// of the sum.
glm::dmat3 rotation(const glm::ivec3& hundredths) {
  const double sx = model::sin_hundredths(hundredths.x);
  const double sy = model::sin_hundredths(hundredths.y);
  const double sz = model::sin_hundredths(hundredths.z);
  const double cx = model::cos_hundredths(hundredths.x);
  const double cy = model::cos_hundredths(hundredths.y);
  const double cz = model::cos_hundredths(hundredths.z);
  return {{cy * cz, cy * sz, -sy},
          {cz * sx * sy - cx * sz, cx * cz + sx * sy * sz, cy * sx},
          {cx * cz * sy + sx * sz, cx * sy * sz - cz * sx, cx * cy}};
}

glm::dmat3 diagonal(const glm::dvec3& entries) {
  glm::dmat3 matrix(0);
  for (int i = 0; i < 3; ++i) matrix[i][i] = entries[i];
  return matrix;
}

/// Whether the scaling or the rotation is applied first.
enum class Order : std::uint8_t { scale_turn, turn_scale };

/// The scale factors of the axes. If the matrix mirrors one axis, all three factors are negative instead.
glm::dvec3 find_scale(const glm::dmat3& written, Order order) {
  const glm::dmat3 lines = order == Order::scale_turn ? written : glm::transpose(written);
  const double sign = glm::determinant(written) < 0.0 ? -1.0 : 1.0;
  glm::dvec3 scale(0);
  for (int i = 0; i < 3; ++i) scale[i] = sign * to_digits(glm::length(lines[i]), 3);
  return scale;
}

std::optional<glm::dmat3> restored(const glm::dmat3& written, Order order) {
  const glm::dvec3 scale = find_scale(written, order);
  const auto scaled = [&](const glm::dmat3& matrix, const glm::dvec3& by) {
    return order == Order::scale_turn ? matrix * diagonal(by) : diagonal(by) * matrix;
  };
  const glm::dmat3 unit = scaled(written, 1.0 / scale);
  if (!is_finite(unit)) return std::nullopt;  // for example because a scale is 0
  const glm::dmat3 turn = rotation(euler_angles(unit));
  const glm::dmat3 whole = scaled(turn, scale);
  const double greatest = std::max({1.0, std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)});
  return is_written_as(whole, written, noise * greatest) ? std::optional(whole) : std::nullopt;
}

}  // namespace

bool is_along_axes(const glm::dmat4& matrix) {
  for (int column = 0; column < 3; ++column) {
    int entries = 0;
    for (int row = 0; row < 3; ++row) entries += matrix[column][row] != 0.0 ? 1 : 0;
    if (entries > 1) return false;
  }
  return true;
}

std::optional<glm::dmat4> restored(const glm::dmat4& written) {
  const glm::dmat3 linear(written);
  std::optional<glm::dmat3> found = restored(linear, Order::scale_turn);
  if (!found) found = restored(linear, Order::turn_scale);
  if (!found) return std::nullopt;
  glm::dmat4 whole(*found);
  whole[3] = written[3];
  return whole;
}

}  // namespace csgsim::read
