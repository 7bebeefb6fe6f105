#include <rapidcheck.h>

#include "host/view/screen_quadric.h"
#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("a quadratic's bounds over a rectangle contain its values and are tight at sides") {
  CHECK(rc::check([] {
    const auto coefficient = [](std::int64_t most) { return *rc::gen::inRange<std::int64_t>(-most, most + 1); };
    const std::int64_t size = *rc::gen::element<std::int64_t>(3, 1000, std::int64_t{1} << 40U);
    const view::FixedQuadratic f{coefficient(size),
                                 coefficient(size),
                                 coefficient(size),
                                 {coefficient(20 * size), coefficient(20 * size), coefficient(400 * size)}};
    const std::int32_t x = *rc::gen::inRange(0, 20);
    const std::int32_t y = *rc::gen::inRange(0, 20);
    const view::PixelRect rect{x, y, x + *rc::gen::inRange(0, 12), y + *rc::gen::inRange(0, 12)};
    const view::Range range = view::range_over(f, rect);
    std::int64_t low = view::value_at(f, x, y);
    std::int64_t high = low;
    bool is_low_at_side = true;
    bool is_high_at_side = true;
    for (std::int32_t py = rect.y0; py <= rect.y1; ++py) {
      for (std::int32_t px = rect.x0; px <= rect.x1; ++px) {
        const std::int64_t value =
            f.xx * px * px + f.xy * px * py + f.yy * py * py + f.linear.a * px + f.linear.b * py + f.linear.c;
        RC_ASSERT(value == view::value_at(f, px, py));
        const bool side = px == rect.x0 || px == rect.x1 || py == rect.y0 || py == rect.y1;
        if (value < low) is_low_at_side = side;
        if (value > high) is_high_at_side = side;
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    RC_ASSERT(range.low <= low);
    RC_ASSERT(range.high >= high);
    const std::int64_t slack = std::abs(f.xx) + std::abs(f.xy) + std::abs(f.yy) + 1;
    RC_ASSERT(range.low >= low - slack);
    RC_ASSERT(range.high <= high + slack);
    const bool is_bowl = 4 * static_cast<double>(f.xx) * static_cast<double>(f.yy) > std::pow(f.xy, 2);
    if (f.xy != 0 || is_bowl) return;
    if (is_low_at_side) RC_ASSERT(range.low == low);
    if (is_high_at_side) RC_ASSERT(range.high == high);
  }));
}

TEST_CASE("bounds of a narrow slanted ridge or valley include its inner pixels") {
  CHECK(rc::check([] {
    const std::int64_t a = *rc::gen::inRange(1, 50);
    const std::int64_t b = *rc::gen::inRange(-50, 50);
    const std::int32_t x = *rc::gen::inRange(1, 9);
    const std::int32_t y = *rc::gen::inRange(1, 9);
    const std::int64_t c = -a * x - b * y;
    const std::int64_t sign = *rc::gen::element(-1, 1);
    // The square of a x + b y + c, which is 0 at that pixel.
    const view::FixedQuadratic f{
        sign * a * a, sign * 2 * a * b, sign * b * b, {sign * 2 * a * c, sign * 2 * b * c, sign * c * c}};
    const view::Range range = view::range_over(f, {0, 0, 10, 10});
    RC_ASSERT((sign > 0 ? range.low : -range.high) <= 0);
  }));
}

TEST_CASE("roots of discriminants are rounded down exactly") {
  CHECK(view::floor_root(0) == 0);
  CHECK(rc::check([] {
    const std::int64_t root = *rc::gen::inRange<std::int64_t>(1, std::int64_t{1} << 30U);
    RC_ASSERT(view::floor_root(root * root) == root);
    RC_ASSERT(view::floor_root(root * root - 1) == root - 1);
  }));
}
