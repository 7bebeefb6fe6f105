#include "sim/judges/surd.h"

namespace csgsim::judges {

namespace {

/// Sign of a sum of two numbers, from their signs and, where they differ, the sign of |first| - |second|.
template <typename CompareSizes>
int sign_of_sum(int first, int second, const CompareSizes& compare_sizes) {
  if (first == 0 || first == second) return second;
  return second == 0 ? first : first * compare_sizes();
}

/// Sign of a + b sqrt(x).
int sign_of(const Dyadic& a, const Dyadic& b, const Dyadic& x) {
  return sign_of_sum(a.sign(), b.sign() * x.sign(), [&] { return (a * a - b * b * x).sign(); });
}

/// Sign of a + b sqrt(x) + c sqrt(y).
int sign_of(const Dyadic& a, const Dyadic& b, const Dyadic& x, const Dyadic& c, const Dyadic& y) {
  const Dyadic first = b * b * x;
  const Dyadic second = c * c * y;
  const int roots = sign_of_sum(b.sign() * x.sign(), c.sign() * y.sign(), [&] { return (first - second).sign(); });
  return sign_of_sum(a.sign(), roots, [&] {
    const Dyadic product = b * c;
    return sign_of(a * a - first - second, -(product + product), x * y);
  });
}

}  // namespace

Real Surd::to_real() const { return (whole.to_real() + root * sqrt(square.to_real())) / over.to_real(); }

int compare(const Surd& a, const Surd& b) {
  const Dyadic whole = a.whole * b.over - b.whole * a.over;
  const int turned = a.over.sign() * b.over.sign();
  if (a.root == 0 && b.root == 0) return turned * whole.sign();
  const Dyadic one(static_cast<double>(a.root));
  const Dyadic other(static_cast<double>(-b.root));
  return turned * sign_of(whole, one * b.over, a.square, other * a.over, b.square);
}

}  // namespace csgsim::judges
