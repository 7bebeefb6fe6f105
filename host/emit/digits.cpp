#include "host/emit/digits.h"

#include <algorithm>
#include <cmath>

namespace csgsim::emit {

namespace {

/// Upper bound of the search: positive digits alone at least halve the rest each time, so the minimum is lower.
constexpr std::size_t most_digits = 12;

bool is_better(const Digits& a, const Digits& b) {
  if (additions(a) != additions(b)) return additions(a) < additions(b);
  return std::abs(a.rest) < std::abs(b.rest);
}

/// Depth-first search that subtracts the power of two just below or just above the rest.
class Search {
 public:
  Search(double number, double error) : error_(error) {
    current_.rest = number;
    binary();
    branch();
  }

  Digits best;

 private:
  /// Starts with the truncated binary representation, which needs no subtraction.
  void binary() {
    best = current_;
    while (best.rest > error_) {
      best.plus.push_back(std::ilogb(best.rest));
      best.rest -= std::ldexp(1.0, best.plus.back());
    }
  }

  void branch() {
    if (std::abs(current_.rest) <= error_) {
      if (is_better(current_, best)) best = current_;
      return;
    }
    if (additions(current_) >= std::min(additions(best), most_digits)) return;
    const int below = std::ilogb(current_.rest);
    take(below);
    take(below + 1);
  }

  void take(int exponent) {
    const double before = current_.rest;
    std::vector<int>& digits = before > 0 ? current_.plus : current_.minus;
    digits.push_back(exponent);
    current_.rest -= std::copysign(std::ldexp(1.0, exponent), before);
    branch();
    current_.rest = before;
    digits.pop_back();
  }

  double error_;
  Digits current_;
};

}  // namespace

std::size_t additions(const Digits& digits) {
  return digits.plus.size() + digits.minus.size() + (digits.minus.empty() ? 0 : 1);
}

Digits fewest_digits(double number, double max_error) { return Search(number, max_error).best; }

}  // namespace csgsim::emit
