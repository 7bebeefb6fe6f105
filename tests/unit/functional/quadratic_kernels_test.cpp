#include "sim/functional/quadratic_kernels.h"

#include "tests/support/quadric_judge.h"
#include "tests/support/test.h"
#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;
using functional::LinearKind;
using test::below_bits;
using test::Quadratic;

namespace {

bool is_sign(LinearKind kind) { return kind == LinearKind::not_negative || kind == LinearKind::negative; }

/// Expected E, and z if `writes`, for F and z.
struct Expected {
  bool enable = false;
  bool writes = false;
  std::int64_t z = 0;
};

Expected expected_of(LinearKind kind, std::int64_t f, std::int64_t z, unsigned field_width) {
  const bool fits = f >= 0 && f >> field_width == 0;
  switch (kind) {
    case LinearKind::not_negative: return {f >= 0};
    case LinearKind::negative: return {f < 0};
    case LinearKind::greater_or_equal: return {f >= z};
    case LinearKind::greater: return {f > z};
    case LinearKind::less_or_equal: return {f <= z};
    case LinearKind::less: return {f < z};
    case LinearKind::equal: return {f == z};
    case LinearKind::load: return {fits, true, f};
    case LinearKind::keep_max: return {fits || f <= z, f > z, f};
    case LinearKind::keep_min: return {fits || f >= z, f < z, f};
    case LinearKind::plus: return {true, true, f + z};
    case LinearKind::minus: return {true, true, f - z};
  }
  return {};
}

constexpr std::array kinds{LinearKind::not_negative, LinearKind::negative, LinearKind::greater_or_equal,
                           LinearKind::greater,      LinearKind::equal,    LinearKind::less_or_equal,
                           LinearKind::less,         LinearKind::load,     LinearKind::keep_max,
                           LinearKind::keep_min,     LinearKind::plus,     LinearKind::minus};

functional::Decide any_decide() {
  return *rc::gen::element(functional::Decide::by_block, functional::Decide::by_pixel);
}

functional::QuadraticTask task_of(LinearKind kind, const Quadratic& sum) {
  return {kind, functional::QuadraticSum(sum.squares, sum.linear), sum.linear.width, sum.linear.shift, nullptr, {}};
}

struct Seen {
  Bits enabled;
  std::uint64_t overflows = 0;
  std::uint32_t count = 0;
};

/// Checks E and the counts, and calls check_z(x, y, previous E, expected value) for each pixel.
template <class Z, class CheckZ>
void check_pixels(const Quadratic& sum, LinearKind kind, unsigned field_width, const Bits& before,
                  const functional::LinearResult& result, const Bits& after, const Z& z, const CheckZ& check_z) {
  std::uint64_t overflows = 0;
  std::uint32_t enabled = 0;
  before.each([&](std::uint32_t x, std::uint32_t y) {
    const bool e = before.at(x, y) != 0;
    const Expected expected = expected_of(kind, sum.f(x, y), z(x, y), field_width);
    RC_ASSERT((after.at(x, y) != 0) == (e && expected.enable));
    check_z(x, y, e && expected.writes, expected.z);
    if (e && !sum.fits(x, y)) ++overflows;
    if (e && expected.enable) ++enabled;
  });
  RC_ASSERT(result.overflows == overflows);
  RC_ASSERT(result.enabled == enabled);
}

}  // namespace

TEST_CASE("operations with quadratic F in lanes match 128-bit arithmetic") {
  CHECK(rc::check([] {
    const functional::TileShape shape = any_shape();
    Quadratic sum = test::any_quadratic({shape.width(), shape.height(), 0});
    if (between(0, 7) == 0) sum.squares = {};
    const LinearKind kind = *rc::gen::elementOf(kinds);
    const unsigned most = std::min(sum.linear.width - sum.linear.shift - 1U, isa::max_field_width);
    const unsigned width = is_sign(kind) ? 0 : between(1U, most + 1);
    functional::TileBits enable;
    const Bits before = set_random(enable, shape);
    const auto lanes = std::make_unique<functional::Lanes>();
    lanes->field = {0, static_cast<std::uint16_t>(width)};
    Numbers numbers(shape);
    functional::QuadraticTask task = task_of(kind, sum);
    if (width > 0) {
      numbers = set_random(*lanes, width, shape);
      task.lanes = lanes.get();
    }
    engine::Work work;
    const functional::LinearResult result = functional::run_quadratic({enable, shape, any_decide(), work}, task);
    const Numbers left = width > 0 ? numbers_of(*lanes, shape) : numbers;
    check_pixels(
        sum, kind, width, before, result, bits_of(enable, shape), [&](auto x, auto y) { return numbers.at(x, y); },
        [&](auto x, auto y, bool writes, std::int64_t z) {
          RC_ASSERT(left.at(x, y) == (writes ? below_bits(z, width) : numbers.at(x, y)));
        });
  }));
}

TEST_CASE("operations with quadratic F in planes match 128-bit arithmetic") {
  CHECK(rc::check([] {
    const functional::TileShape shape = any_shape();
    const Quadratic sum = test::any_quadratic({shape.width(), shape.height(), 0});
    const LinearKind kind = *rc::gen::element(LinearKind::load, LinearKind::plus, LinearKind::minus);
    const unsigned width = sum.linear.width - sum.linear.shift - 1U;
    std::vector<std::unique_ptr<functional::TileBits>> planes;
    std::vector<functional::TileBits*> field;
    std::vector<Bits> bits;
    for (unsigned bit = 0; bit < width; ++bit) {
      field.push_back(planes.emplace_back(std::make_unique<functional::TileBits>()).get());
      bits.push_back(set_random(*field.back(), shape));
    }
    functional::TileBits enable;
    const Bits before = set_random(enable, shape);
    functional::QuadraticTask task = task_of(kind, sum);
    task.planes = field;
    engine::Work work;
    const functional::LinearResult result = functional::run_quadratic({enable, shape, any_decide(), work}, task);
    std::vector<Bits> left;
    for (const functional::TileBits* plane : field) left.push_back(bits_of(*plane, shape));
    const auto value = [&](const std::vector<Bits>& of, std::uint32_t x, std::uint32_t y) {
      std::uint64_t number = 0;
      for (std::size_t bit = 0; bit < of.size(); ++bit) number |= std::uint64_t{of[bit].at(x, y) != 0} << bit;
      return static_cast<std::int64_t>(number);
    };
    check_pixels(
        sum, kind, width, before, result, bits_of(enable, shape), [&](auto x, auto y) { return value(bits, x, y); },
        [&](auto x, auto y, bool writes, std::int64_t z) {
          RC_ASSERT(value(left, x, y) ==
                    (writes ? static_cast<std::int64_t>(below_bits(z, width)) : value(bits, x, y)));
        });
  }));
}

TEST_CASE("bounds of a quadratic contain all values and are tight without a product xy") {
  CHECK(rc::check([] {
    const std::uint32_t width = between(1U, 65U);
    const std::uint32_t height = between(1U, 65U);
    Quadratic sum = test::any_quadratic({200, 100, 0});
    if (between(0, 1) == 0) sum.squares.b = 0;
    const std::uint32_t x = between(0U, 200 - width);
    const std::uint32_t y = between(0U, 100 - height);
    const functional::QuadraticSum from_there = functional::QuadraticSum(sum.squares, sum.linear).from(x, y);
    RC_PRE(from_there.can_bound());
    const auto range = from_there.range(width, height);
    test::Wide least = sum.sum(x, y);
    test::Wide greatest = least;
    for (std::uint32_t j = 0; j < height; ++j) {
      for (std::uint32_t i = 0; i < width; ++i) {
        least = std::min(least, sum.sum(x + i, y + j));
        greatest = std::max(greatest, sum.sum(x + i, y + j));
      }
    }
    RC_ASSERT(range.least <= least);
    RC_ASSERT(range.greatest >= greatest);
    if (sum.squares.b == 0) {
      RC_ASSERT(range.least == least);
      RC_ASSERT(range.greatest == greatest);
    }
  }));
}

TEST_CASE("blocks decided by a quadratic's bounds are not evaluated per pixel") {
  // A circle of radius 20 around (32, 32).
  const Quadratic circle{{-1, 0, -1, 20, 0}, {64, 64, 400 - 2 * 32 * 32, 20, 0}};
  const functional::TileShape shape(64, 64);
  for (const auto& [decide, blocks] :
       {std::pair{functional::Decide::by_block, 20U}, {functional::Decide::by_pixel, 64U}}) {
    functional::TileBits enable;
    enable.fill(shape);
    engine::Work work;
    functional::run_quadratic({enable, shape, decide, work}, task_of(LinearKind::not_negative, circle));
    CHECK(work.words == blocks);
  }
}
