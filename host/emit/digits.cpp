#include "host/emit/digits.h"

#include <algorithm>
#include <cmath>

namespace csgsim::emit {

namespace {

/// More digits than this are never the fewest: positive ones alone halve the rest each time.
constexpr std::size_t most_digits = 12;

bool is_better(const Digits& a, const Digits& b) {
  if (additions(a) != additions(b)) return additions(a) < additions(b);
  return std::abs(a.rest) < std::abs(b.rest);
}

/// The powers of two on either side of what is left, one after another.
class Search {
 public:
  Search(double number, double error) : error_(error) {
    so_far_.rest = number;
    binary();
    branch();
  }

  Digits best;

 private:
  /// Begins with the number cut off, which needs no subtraction.
  void binary() {
    best = so_far_;
    while (best.rest > error_) {
      best.plus.push_back(std::ilogb(best.rest));
      best.rest -= std::ldexp(1.0, best.plus.back());
    }
  }

  void branch() {
    if (std::abs(so_far_.rest) <= error_) {
      if (is_better(so_far_, best)) best = so_far_;
      return;
    }
    if (additions(so_far_) >= std::min(additions(best), most_digits)) return;
    const int below = std::ilogb(so_far_.rest);
    take(below);
    take(below + 1);
  }

  void take(int exponent) {
    const double before = so_far_.rest;
    std::vector<int>& digits = before > 0 ? so_far_.plus : so_far_.minus;
    digits.push_back(exponent);
    so_far_.rest -= std::copysign(std::ldexp(1.0, exponent), before);
    branch();
    so_far_.rest = before;
    digits.pop_back();
  }

  double error_;
  Digits so_far_;
};

}  // namespace

std::size_t additions(const Digits& digits) {
  return digits.plus.size() + digits.minus.size() + (digits.minus.empty() ? 0 : 1);
}

Digits fewest_digits(double number, double error) { return Search(number, error).best; }

}  // namespace csgsim::emit
