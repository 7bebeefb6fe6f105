// Exact arithmetic on dyadic rationals.
// Used by the exact cameras and sights of the judges.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <glm/vec3.hpp>

namespace csgsim::judges {

using Integer = boost::multiprecision::cpp_int;

/// A number of 100 decimal digits, for square roots, which are computed once per picture.
using Real = boost::multiprecision::cpp_bin_float_100;

/// An exact number m * 2^e. All finite doubles, and their sums and products, are such numbers.
class Dyadic {
 public:
  Dyadic() = default;

  /// `value` must be finite.
  explicit Dyadic(double value);

  /// Converts all digits of `value`, which must be finite.
  explicit Dyadic(const Real& value);

  [[nodiscard]] int sign() const { return mantissa_.sign(); }

  /// The value with a relative error of at most 2^-52; 0 or infinite outside the range of doubles.
  [[nodiscard]] double to_double() const;

  [[nodiscard]] Real to_real() const;

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);

 private:
  Dyadic(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  Integer mantissa_;
  int exponent_ = 0;
};

using Vector = std::array<Dyadic, 3>;

/// The vector without rounding; its elements must be finite.
Vector to_exact(const glm::dvec3& v);
Vector operator-(const Vector& a, const Vector& b);
Dyadic dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);

}  // namespace csgsim::judges
