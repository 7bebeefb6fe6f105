#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <glm/vec3.hpp>

namespace csgsim::judges {

using Integer = boost::multiprecision::cpp_int;

/// 100 decimal digits: for square roots, once a picture.
using Real = boost::multiprecision::cpp_bin_float_100;

/// An exact number m * 2^e. Every finite double is one, and sums and products of them are.
class Dyadic {
 public:
  Dyadic() = default;

  /// `value` has to be finite.
  explicit Dyadic(double value);

  /// All digits of `value`, which has to be finite.
  explicit Dyadic(const Real& value);

  [[nodiscard]] int sign() const { return mantissa_.sign(); }

  /// Off by at most 2^-52 of the value; 0 or infinite beyond the range of doubles.
  [[nodiscard]] double approximately() const;

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

Vector exactly(const glm::dvec3& v);
Vector operator-(const Vector& a, const Vector& b);
Dyadic dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);

}  // namespace csgsim::judges
