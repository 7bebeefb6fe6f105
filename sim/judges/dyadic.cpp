#include "sim/judges/dyadic.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace csgsim::judges {

namespace {

constexpr int double_digits = 53;
constexpr unsigned word_bits = 64;

/// More bits than a Real has.
constexpr int real_digits = 360;

}  // namespace

Dyadic::Dyadic(double value) {
  int exponent = 0;
  const double part = std::frexp(value, &exponent);
  mantissa_ = static_cast<std::int64_t>(std::ldexp(part, double_digits));
  exponent_ = exponent - double_digits;
}

Dyadic::Dyadic(const Real& value) {
  int exponent = 0;
  const Real part = frexp(value, &exponent);
  mantissa_ = Real(ldexp(part, real_digits)).convert_to<Integer>();
  exponent_ = exponent - real_digits;
}

double Dyadic::to_double() const {
  if (mantissa_.is_zero()) return 0.0;
  const Integer size = mantissa_.sign() < 0 ? Integer(-mantissa_) : mantissa_;
  const auto top = static_cast<unsigned>(msb(size)) + 1;
  const unsigned drop = top > word_bits ? top - word_bits : 0;
  const double leading = static_cast<double>(static_cast<std::uint64_t>(size >> drop));
  return std::ldexp(mantissa_.sign() < 0 ? -leading : leading, exponent_ + static_cast<int>(drop));
}

Real Dyadic::to_real() const { return ldexp(Real(mantissa_), exponent_); }

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.mantissa_.is_zero()) return b;
  if (b.mantissa_.is_zero()) return a;
  const int exponent = std::min(a.exponent_, b.exponent_);
  return {(a.mantissa_ << (a.exponent_ - exponent)) + (b.mantissa_ << (b.exponent_ - exponent)), exponent};
}

Dyadic operator-(const Dyadic& a) { return {-a.mantissa_, a.exponent_}; }

Dyadic operator*(const Dyadic& a, const Dyadic& b) { return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_}; }

Vector to_exact(const glm::dvec3& v) { return {Dyadic(v.x), Dyadic(v.y), Dyadic(v.z)}; }

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Dyadic dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace csgsim::judges
