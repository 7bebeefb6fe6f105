#include "sim/functional/linear_kernels.h"

#include <doctest/doctest.h>

#include "tests/unit/functional/blocks.h"

using namespace csgsim;
using namespace csgsim::testing;
using sim::LinearKind;
using sim::LinearTask;

namespace {

using Lanes = std::vector<std::uint32_t>;

/// An expression S = a x + b y + c, x and y counted from the block's first pixel, and how F comes of it.
struct Expression {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t c = 0;
  unsigned width = 0;
  unsigned shift = 0;
  unsigned field_width = 0;  ///< 0: none

  [[nodiscard]] std::int64_t sum(std::size_t x, std::size_t y) const {
    return a * static_cast<std::int64_t>(x) + b * static_cast<std::int64_t>(y) + c;
  }
  /// The low `width` bits as a two's complement number.
  [[nodiscard]] std::int64_t kept(std::size_t x, std::size_t y) const {
    const std::int64_t period = std::int64_t{1} << width;
    const std::int64_t low = (sum(x, y) % period + period) % period;
    return low >= period / 2 ? low - period : low;
  }
  [[nodiscard]] bool fits(std::size_t x, std::size_t y) const { return sum(x, y) == kept(x, y); }
  /// Shifted with floor.
  [[nodiscard]] std::int64_t f(std::size_t x, std::size_t y) const {
    const std::int64_t step = std::int64_t{1} << shift;
    const std::int64_t s = kept(x, y);
    return s / step - (s % step < 0 ? 1 : 0);
  }
};

/// Whose F is often near the values of the field, or near 0 without one.
Expression any_expression(unsigned field_width, bool wraps) {
  Expression expression;
  expression.field_width = field_width;
  expression.shift = between(0U, 13U);
  expression.width = field_width + expression.shift + 1 + between(0U, wraps ? 3U : 16U);
  const std::int64_t range = std::int64_t{1} << (expression.width - 1);
  const auto slope = [&] {
    const std::int64_t most = std::max<std::int64_t>(wraps ? range / 16 : range / 1024, 1);
    return between<std::int64_t>(-most, most + 1);
  };
  expression.a = slope();
  expression.b = slope();
  expression.c = between<std::int64_t>(-range / 4, range / 4 + 1);
  return expression;
}

/// Whether S fits the width at all pixels that a block of any_words can have.
bool fits_everywhere(const Expression& expression) {
  return expression.fits(0, 0) && expression.fits(191, 0) && expression.fits(0, 3) && expression.fits(191, 3);
}

LinearTask task_of(const Expression& expression, LinearKind kind, std::int64_t bias) {
  LinearTask task;
  task.kind = kind;
  task.wraps = !fits_everywhere(expression);
  task.start = static_cast<std::uint64_t>(expression.c);
  task.a = static_cast<std::uint64_t>(expression.a);
  task.b = static_cast<std::uint64_t>(expression.b);
  task.bias = static_cast<std::uint64_t>(bias);
  task.width = expression.width;
  task.shift = expression.shift;
  task.field_width = expression.field_width;
  return task;
}

std::uint64_t overflows(const Words& enable, const Expression& expression) {
  std::uint64_t count = 0;
  enable.for_each([&](std::size_t lane, std::size_t x, std::size_t y) {
    if (enable.at(lane) && !expression.fits(x, y)) ++count;
  });
  return count;
}

/// Runs a task that only keeps or clears E, and checks it against keeps(F, lane).
template <class Keeps>
void check_compares(LinearTask task, const Expression& expression, const Keeps& keeps) {
  Words enable = any_words();
  Lanes lanes = any_lanes(enable.lanes(), expression.field_width);
  // Lanes that F equals.
  enable.for_each([&](std::size_t lane, std::size_t x, std::size_t y) {
    const std::int64_t f = expression.f(x, y);
    if (lane % 3 == 0 && f >= 0 && f < std::int64_t{1} << expression.field_width)
      lanes[lane] = static_cast<std::uint32_t>(f);
  });
  const Lanes before = lanes;
  Words expected = enable;
  enable.for_each([&](std::size_t lane, std::size_t x, std::size_t y) {
    expected.set(lane, enable.at(lane) && keeps(expression.f(x, y), static_cast<std::int64_t>(lanes[lane])));
  });
  task.lanes = lanes.data() + enable.first_lane();
  const std::uint64_t expected_overflows = overflows(enable, expression);
  RC_ASSERT(sim::run_linear(enable.block(), task) == expected_overflows);
  RC_ASSERT(enable.words == expected.words);
  RC_ASSERT(lanes == before);
}

/// Runs a task that writes lanes where writes(F, lane), and checks it.
template <class Writes>
void check_writes(LinearTask task, const Expression& expression, const Writes& writes) {
  Words enable = any_words();
  Lanes lanes = any_lanes(enable.lanes(), expression.field_width);
  const std::int64_t end = std::int64_t{1} << expression.field_width;
  Words expected = enable;
  Lanes expected_lanes = lanes;
  enable.for_each([&](std::size_t lane, std::size_t x, std::size_t y) {
    const std::int64_t f = expression.f(x, y);
    if (!enable.at(lane) || !writes(f, static_cast<std::int64_t>(lanes[lane]))) return;
    expected_lanes[lane] = static_cast<std::uint32_t>((f % end + end) % end);
    expected.set(lane, f >= 0 && f < end);
  });
  task.lanes = lanes.data() + enable.first_lane();
  const std::uint64_t expected_overflows = overflows(enable, expression);
  RC_ASSERT(sim::run_linear(enable.block(), task) == expected_overflows);
  RC_ASSERT(enable.words == expected.words);
  RC_ASSERT(lanes == expected_lanes);
}

/// Expressions that fit their width everywhere, and others.
Expression any_for_field() { return any_expression(between(1U, 33U), between(0, 2) == 0); }

}  // namespace

TEST_CASE("a sign keeps what is not negative, or what is") {
  CHECK(rc::check([] {
    const Expression expression = any_expression(0, between(0, 2) == 0);
    LinearTask task = task_of(expression, LinearKind::sign, 1);
    check_compares(task, expression, [](std::int64_t f, std::int64_t) { return f >= 0; });
    task.negate = true;
    check_compares(task, expression, [](std::int64_t f, std::int64_t) { return f < 0; });
  }));
}

TEST_CASE("a comparison keeps where F is at least the lane, or greater, or not so") {
  CHECK(rc::check([] {
    const Expression expression = any_for_field();
    const std::int64_t for_greater = 1 - (std::int64_t{1} << expression.shift);
    LinearTask at_least = task_of(expression, LinearKind::compare, 1);
    LinearTask greater = task_of(expression, LinearKind::compare, for_greater);
    check_compares(at_least, expression, [](std::int64_t f, std::int64_t z) { return f >= z; });
    check_compares(greater, expression, [](std::int64_t f, std::int64_t z) { return f > z; });
    at_least.negate = greater.negate = true;
    check_compares(at_least, expression, [](std::int64_t f, std::int64_t z) { return f < z; });
    check_compares(greater, expression, [](std::int64_t f, std::int64_t z) { return f <= z; });
  }));
}

TEST_CASE("equality keeps where F is the lane, whatever its fraction") {
  CHECK(rc::check([] {
    const Expression expression = any_for_field();
    check_compares(task_of(expression, LinearKind::equal, 0), expression,
                   [](std::int64_t f, std::int64_t z) { return f == z; });
  }));
}

TEST_CASE("a load writes the low bits of F where enabled, and clears E where F does not fit") {
  CHECK(rc::check([] {
    const Expression expression = any_for_field();
    check_writes(task_of(expression, LinearKind::load, 0), expression, [](std::int64_t, std::int64_t) { return true; });
  }));
}

TEST_CASE("the greater or the less of F and the lane is kept, and E cleared where what is written does not fit") {
  CHECK(rc::check([] {
    const Expression expression = any_for_field();
    const std::int64_t for_greater = 1 - (std::int64_t{1} << expression.shift);
    check_writes(task_of(expression, LinearKind::keep_max, for_greater), expression,
                 [](std::int64_t f, std::int64_t z) { return f > z; });
    check_writes(task_of(expression, LinearKind::keep_min, 0), expression,
                 [](std::int64_t f, std::int64_t z) { return f < z; });
  }));
}
