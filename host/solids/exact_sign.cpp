#include "host/solids/exact_sign.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "host/model/two_doubles.h"

namespace csgsim::solids {

namespace {

// Numbers are stored as sums of non-overlapping doubles, smallest first, without zeros. The steps follow the theorems
// of J. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates" (1997).

/// A sum of up to `capacity` components.
template <std::size_t capacity>
struct Sum {
  std::array<double, capacity> parts;
  std::size_t count = 0;

  void append(double part) {
    if (part != 0.0) parts[count++] = part;
  }
};

template <std::size_t capacity>
void add(Sum<capacity>& sum, double more) {
  const std::size_t count = sum.count;
  sum.count = 0;
  double carried = more;
  for (std::size_t i = 0; i < count; ++i) {
    const model::TwoDoubles step = model::exact_sum(carried, sum.parts[i]);
    sum.append(step.low);
    carried = step.high;
  }
  sum.append(carried);
}

template <std::size_t a, std::size_t b>
Sum<a + b> operator+(const Sum<a>& one, const Sum<b>& other) {
  Sum<a + b> sum;
  sum.count = one.count;
  std::copy_n(one.parts.begin(), one.count, sum.parts.begin());
  for (std::size_t i = 0; i < other.count; ++i) add(sum, other.parts[i]);
  return sum;
}

template <std::size_t a, std::size_t b>
Sum<2 * a * b> operator*(const Sum<a>& one, const Sum<b>& other) {
  Sum<2 * a * b> sum;
  for (std::size_t i = 0; i < one.count; ++i) {
    for (std::size_t j = 0; j < other.count; ++j) {
      const model::TwoDoubles product = model::exact_product(one.parts[i], other.parts[j]);
      add(sum, product.low);
      add(sum, product.high);
    }
  }
  return sum;
}

template <std::size_t capacity>
Sum<capacity> operator-(Sum<capacity> sum) {
  for (std::size_t i = 0; i < sum.count; ++i) sum.parts[i] = -sum.parts[i];
  return sum;
}

using Component = Sum<2>;
using Row = std::array<Component, 3>;

Component difference(double to, double from) {
  const model::TwoDoubles pair = model::exact_sum(to, -from);
  Component component;
  component.append(pair.low);
  component.append(pair.high);
  return component;
}

Row exact_row(const Difference& row) {
  return {difference(row.to.x, row.from.x), difference(row.to.y, row.from.y), difference(row.to.z, row.from.z)};
}

int sign(double number) { return number > 0.0 ? 1 : number < 0.0 ? -1 : 0; }

int exact_sign(const std::array<Difference, 3>& rows) {
  const Row a = exact_row(rows[0]);
  const Row b = exact_row(rows[1]);
  const Row c = exact_row(rows[2]);
  const auto minor = [&](std::size_t i, std::size_t j) { return b[i] * c[j] + -(b[j] * c[i]); };
  const auto sum = a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1);
  return sum.count == 0 ? 0 : sign(sum.parts[sum.count - 1]);
}

/// Whether products of three differences of coordinates of this size, and their rounding errors, stay in the range of
/// doubles.
bool is_moderate(double coordinate) {
  const double size = std::abs(coordinate);
  return size == 0.0 || (size < 1e90 && size > 1e-75);
}

bool is_moderate(const glm::dvec3& point) {
  return is_moderate(point.x) && is_moderate(point.y) && is_moderate(point.z);
}

}  // namespace

std::optional<int> sign_of_determinant(const std::array<Difference, 3>& rows) {
  const glm::dvec3 a = rows[0].to - rows[0].from;
  const glm::dvec3 b = rows[1].to - rows[1].from;
  const glm::dvec3 c = rows[2].to - rows[2].from;
  const double xy = b.x * c.y;
  const double yx = b.y * c.x;
  const double yz = b.y * c.z;
  const double zy = b.z * c.y;
  const double zx = b.z * c.x;
  const double xz = b.x * c.z;
  const double determinant = a.x * (yz - zy) + a.y * (zx - xz) + a.z * (xy - yx);
  const double sizes = std::abs(a.x) * (std::abs(yz) + std::abs(zy)) + std::abs(a.y) * (std::abs(zx) + std::abs(xz)) +
                       std::abs(a.z) * (std::abs(xy) + std::abs(yx));
  // Shewchuk's bound for differences, products and sums that are each rounded once: (7 + 56 e) e, where e is half a
  // unit in the last place.
  constexpr double e = std::numeric_limits<double>::epsilon() / 2;
  if (std::abs(determinant) > (7 + 56 * e) * e * sizes && sizes > 1e-200) return sign(determinant);
  for (const Difference& row : rows) {
    if (!is_moderate(row.to) || !is_moderate(row.from)) return std::nullopt;
  }
  return exact_sign(rows);
}

}  // namespace csgsim::solids
