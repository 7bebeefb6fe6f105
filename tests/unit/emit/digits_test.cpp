#include "host/emit/digits.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;
using emit::Digits;

namespace {

double value_of(const Digits& digits) {
  double value = 0;
  for (const int exponent : digits.plus) value += std::ldexp(1.0, exponent);
  for (const int exponent : digits.minus) value -= std::ldexp(1.0, exponent);
  return value;
}

/// Additions for the number's binary digits, from the largest down to the error.
std::size_t binary_additions(double number, double error) {
  std::size_t count = 0;
  while (number > error) {
    number -= std::exp2(std::floor(std::log2(number)));
    ++count;
  }
  return count;
}

void check_hand_case(double number, double error, const Digits& expected) {
  const Digits digits = emit::fewest_digits(number, error);
  CAPTURE(number);
  CHECK(digits.plus == expected.plus);
  CHECK(digits.minus == expected.minus);
  CHECK(digits.rest == expected.rest);
}

/// Minimum number of additions for each multiple of the smallest power that sums and differences of at most `most`
/// powers of two in a range of exponents can reach.
class Reached {
 public:
  Reached(int lowest, int highest, unsigned most) : lowest_(lowest), highest_(highest), most_(most) { add(0, 0, 0); }

  /// Minimum number of additions for a number within the error; `most` + 2 if there is no such sum.
  [[nodiscard]] std::size_t fewest(double number, double error) const {
    std::size_t best = most_ + 2;
    for (const auto& [value, additions] : sums_)
      if (std::abs(number - value) <= error) best = std::min(best, additions);
    return best;
  }

 private:
  struct Sum {
    double value;
    std::size_t additions;
  };

  void add(double value, unsigned plus, unsigned minus) {
    sums_.push_back({value, plus + minus + (minus > 0 ? 1U : 0U)});
    if (plus + minus == most_) return;
    for (int exponent = lowest_; exponent <= highest_; ++exponent) {
      const double power = std::ldexp(1.0, exponent);
      if (minus == 0) add(value + power, plus + 1, 0);
      add(value - power, plus, minus + 1);
    }
  }

  int lowest_;
  int highest_;
  unsigned most_;
  std::vector<Sum> sums_;
};

}  // namespace

TEST_CASE("the signed digits of numbers match hand calculations") {
  check_hand_case(0, 0.01, {{}, {}, 0});
  check_hand_case(0.25, 0.25, {{}, {}, 0.25});
  check_hand_case(8, 0.01, {{3}, {}, 0});
  check_hand_case(5, 0.01, {{2, 0}, {}, 0});
  check_hand_case(7, 0.01,
                  {{2, 1, 0}, {}, 0});  // 8 - 1 reverses the sum, which costs the same; the binary form cuts nothing
  check_hand_case(15, 0.01, {{4}, {0}, 0});
  check_hand_case(7.9, 0.2, {{3}, {}, 7.9 - 8});
  check_hand_case(0.125 + 1.0 / 64, 0.001, {{-3, -6}, {}, 0});
  check_hand_case(59, 0.01, {{6}, {2, 0}, 0});
}

TEST_CASE("signed digits are within the error and no more than the binary digits") {
  for (int round = 0; round < 5; ++round) {
    CHECK(rc::check([&] {
      const auto real = [] { return *rc::gen::inRange(1, 1'000'001) / 1e6; };
      const double number = std::ldexp(real(), *rc::gen::inRange(-12, 13));
      const double error = number * std::ldexp(real(), -*rc::gen::inRange(0, 13));
      const Digits digits = emit::fewest_digits(number, error);
      RC_ASSERT(std::abs(digits.rest) <= error);
      RC_ASSERT(std::abs(number - value_of(digits) - digits.rest) <= 1e-12 * number);
      RC_ASSERT(emit::additions(digits) <= binary_additions(number, error));
      RC_ASSERT(std::is_sorted(digits.plus.rbegin(), digits.plus.rend()));
      RC_ASSERT(std::is_sorted(digits.minus.rbegin(), digits.minus.rend()));
    }));
  }
}

TEST_CASE("no signed digits with exponents from -5 to 5 take fewer additions") {
  const Reached reached(-5, 5, 4);
  int differences = 0;
  int worse = 0;
  for (int i = 1; i < 600; ++i) {
    const double number = i * 13.0 / 600;
    for (const double error : {1.0 / 32, 1.0 / 9, 0.4}) {
      const Digits digits = emit::fewest_digits(number, error);
      differences += digits.minus.empty() ? 0 : 1;
      if (emit::additions(digits) > reached.fewest(number, error)) ++worse;
    }
  }
  CHECK(worse == 0);
  CHECK(differences > 20);
}
