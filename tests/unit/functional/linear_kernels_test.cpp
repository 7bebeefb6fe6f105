#include "sim/functional/linear_kernels.h"

#include "tests/support/test.h"
#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;
using functional::LinearKind;
using functional::LinearTask;

namespace {

/// An expression S = a x + b y + c, with x and y relative to the tile's first pixel, and the parameters of F.
struct Expression {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t c = 0;
  unsigned width = 0;
  unsigned shift = 0;
  unsigned field_width = 0;  ///< 0 without a field

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
  /// Shifts right, rounding down.
  [[nodiscard]] std::int64_t f(std::size_t x, std::size_t y) const {
    const std::int64_t step = std::int64_t{1} << shift;
    const std::int64_t s = kept(x, y);
    return s / step - (s % step < 0 ? 1 : 0);
  }
};

/// F is often near the values of the field, or near 0 without one; the slope is flat, steep, or steeper than in any
/// picture.
Expression any_expression(unsigned field_width, bool wraps) {
  Expression expression;
  expression.field_width = field_width;
  expression.shift = between(0U, 13U);
  expression.width = field_width + expression.shift + 1 + between(0U, wraps ? 3U : 16U);
  const std::int64_t range = std::int64_t{1} << (expression.width - 1);
  const auto slope = [&] {
    const std::int64_t most =
        std::max<std::int64_t>(wraps ? range / 16 : range / *rc::gen::element<std::int64_t>(128, 1024, 1 << 20), 1);
    return between<std::int64_t>(-most, most + 1);
  };
  expression.a = slope();
  expression.b = slope();
  expression.c = between<std::int64_t>(-range / 4, range / 4 + 1);
  if (wraps && between(0, 4) == 0) expression.a = between<std::int64_t>(-1, 2) << 54U;
  return expression;
}

/// Mixes expressions that fit their width everywhere with others.
Expression any_expression(unsigned field_width) { return any_expression(field_width, between(0, 2) == 0); }

/// Some pixels of a tile and a field, together with a per-pixel reference.
struct Tile {
  Expression expression;
  functional::TileShape shape = any_shape();
  functional::TileBits enable;
  Bits enabled = set_random(enable, shape);
  std::unique_ptr<functional::Lanes> lanes = std::make_unique<functional::Lanes>();
  Numbers numbers{shape};

  explicit Tile(const Expression& any) : expression(any) {
    if (expression.field_width == 0) return;
    set_random(*lanes, expression.field_width, shape);
    // Makes some pixels of a block equal to F.
    for (unsigned block = 0; block < functional::blocks_per_tile; block += between(1U, 4U)) {
      if (lanes->is_constant(block)) functional::fill_block(*lanes, block);
      for (unsigned bit = 0; bit < functional::block_pixels; bit += 2) {
        const std::int64_t f = expression.f(block % 8 * 8 + bit % 8, block / 8 * 8 + bit / 8);
        if (f >= 0 && f < field_end()) lanes->block(block)[bit] = static_cast<std::uint32_t>(f);
      }
      functional::find_bounds(*lanes, block);
    }
    numbers = numbers_of(*lanes, shape);
  }

  [[nodiscard]] std::int64_t field_end() const { return std::int64_t{1} << expression.field_width; }

  [[nodiscard]] std::uint64_t overflows() const {
    std::uint64_t count = 0;
    enabled.each([&](std::uint32_t x, std::uint32_t y) {
      if (enabled.at(x, y) != 0 && !expression.fits(x, y)) ++count;
    });
    return count;
  }

  /// Runs the kind and asserts the number of overflows.
  void run(LinearKind kind) {
    LinearTask task;
    task.kind = kind;
    task.linear = {expression.a, expression.b, expression.c, static_cast<std::uint16_t>(expression.width),
                   static_cast<std::uint16_t>(expression.shift)};
    task.lanes = expression.field_width == 0 ? nullptr : lanes.get();
    engine::Work work;
    const functional::Decide decide = between(0, 3) == 0 ? functional::Decide::by_pixel : functional::Decide::by_block;
    const std::uint64_t expected = overflows();
    const functional::LinearResult result =
        functional::run_linear({enable, shape, decide, work}, task, functional::count_ones(enable, shape));
    RC_ASSERT(result.overflows == expected);
    RC_ASSERT(result.enabled == functional::count_ones(enable, shape));
  }

  void check() const {
    RC_ASSERT(bits_of(enable, shape) == enabled);
    if (expression.field_width > 0) RC_ASSERT(numbers_of(*lanes, shape) == numbers);
  }
};

/// Runs a kind that only keeps or clears E, and checks it against keeps(F, z).
template <class Keeps>
void check_tests(const Expression& expression, LinearKind kind, const Keeps& keeps) {
  Tile tile(expression);
  tile.run(kind);
  tile.enabled.set_each([&](std::uint32_t x, std::uint32_t y) {
    const bool kept = tile.enabled.at(x, y) != 0 && keeps(expression.f(x, y), std::int64_t{tile.numbers.at(x, y)});
    return static_cast<char>(kept ? 1 : 0);
  });
  tile.check();
}

/// Runs a kind that writes z where writes(F, z), and checks it.
template <class Writes>
void check_writes(const Expression& expression, LinearKind kind, const Writes& writes) {
  Tile tile(expression);
  tile.run(kind);
  const std::int64_t end = tile.field_end();
  tile.enabled.each([&](std::uint32_t x, std::uint32_t y) {
    const std::int64_t f = expression.f(x, y);
    if (tile.enabled.at(x, y) == 0 || !writes(f, std::int64_t{tile.numbers.at(x, y)})) return;
    tile.numbers.set(x, y, static_cast<std::uint32_t>((f % end + end) % end));
    tile.enabled.set(x, y, static_cast<char>(f >= 0 && f < end ? 1 : 0));
  });
  tile.check();
}

Expression any_for_field() { return any_expression(*rc::gen::element(1U, 20U, 29U, 30U, 32U, between(1U, 33U))); }

}  // namespace

TEST_CASE("a sign test keeps non-negative or negative pixels") {
  CHECK(rc::check([] {
    check_tests(any_expression(0), LinearKind::not_negative, [](std::int64_t f, std::int64_t) { return f >= 0; });
    check_tests(any_expression(0), LinearKind::negative, [](std::int64_t f, std::int64_t) { return f < 0; });
  }));
}

TEST_CASE("a comparison with F keeps enabled the pixels that satisfy it") {
  CHECK(rc::check([] {
    using enum LinearKind;
    check_tests(any_for_field(), greater_or_equal, [](std::int64_t f, std::int64_t z) { return f >= z; });
    check_tests(any_for_field(), greater, [](std::int64_t f, std::int64_t z) { return f > z; });
    check_tests(any_for_field(), less, [](std::int64_t f, std::int64_t z) { return f < z; });
    check_tests(any_for_field(), less_or_equal, [](std::int64_t f, std::int64_t z) { return f <= z; });
    check_tests(any_for_field(), equal, [](std::int64_t f, std::int64_t z) { return f == z; });
  }));
}

TEST_CASE("load_linear writes the low bits of F and clears E where F does not fit") {
  CHECK(rc::check(
      [] { check_writes(any_for_field(), LinearKind::load, [](std::int64_t, std::int64_t) { return true; }); }));
}

TEST_CASE("keep_max and keep_min update the field and clear E on overflow") {
  CHECK(rc::check([] {
    check_writes(any_for_field(), LinearKind::keep_max, [](std::int64_t f, std::int64_t z) { return f > z; });
    check_writes(any_for_field(), LinearKind::keep_min, [](std::int64_t f, std::int64_t z) { return f < z; });
  }));
}

// The sum is 0 at the last pixel and negative elsewhere. With 30 of its 36 bits, seven steps along a row and seven
// along a column lose at least 0.875 each, 13 in total: bounds with a smaller margin would classify the last block as
// negative.
TEST_CASE("a block with a maximum sum of 0 is evaluated despite truncated bounds") {
  constexpr std::int64_t slope = (std::int64_t{1} << 29U) + 7;
  const Expression expression{.a = slope, .b = slope, .c = -126 * slope, .width = 40};
  REQUIRE(expression.sum(63, 63) == 0);
  const functional::TileShape shape(64, 64);
  for (const LinearKind kind : {LinearKind::not_negative, LinearKind::negative}) {
    functional::TileBits enable;
    enable.fill(shape);
    LinearTask task;
    task.kind = kind;
    task.linear = {expression.a, expression.b, expression.c, 40, 0};
    engine::Work work;
    functional::run_linear({enable, shape, functional::Decide::by_block, work}, task, shape.area());
    const Bits kept = bits_of(enable, shape);
    kept.each([&](std::uint32_t x, std::uint32_t y) {
      CHECK((kept.at(x, y) != 0) == ((expression.sum(x, y) >= 0) == (kind == LinearKind::not_negative)));
    });
  }
}