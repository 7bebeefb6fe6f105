#include "sim/functional/edge.h"

#include <doctest/doctest.h>

#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;
using sim::BitPlane;
using sim::HalfPlane;

namespace {

/// A line that mostly crosses the pixels, with slopes of any size up to 2^48, level or upright ones among them.
HalfPlane any_half_plane(const Pixels& pixels) {
  const auto slope = [] {
    const auto most = std::int64_t{1} << between(0, 49);
    return between(0, 6) == 0 ? std::int64_t{0} : between<std::int64_t>(-most, most + 1);
  };
  HalfPlane half_plane{slope(), slope(), 0};
  const std::int64_t x = between<std::int64_t>(-2, pixels.width() + 2);
  const std::int64_t y = between<std::int64_t>(-2, pixels.height() + 2);
  half_plane.c = -half_plane.a * x - half_plane.b * y + between<std::int64_t>(-2, 3);
  return half_plane;
}

void check_clip(BitPlane& plane, const Pixels& before, const HalfPlane& half_plane) {
  const sim::Rect old = plane.bounds();
  Pixels expected = before;
  expected.set_each([&](std::int64_t x, std::int64_t y) {
    return before.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) &&
           half_plane.a * x + half_plane.b * y + half_plane.c >= 0;
  });
  sim::clip(plane, half_plane);
  RC_ASSERT(pixels_of(plane) == expected);
  RC_ASSERT(sim::contains(plane.bounds(), expected.bounds()));
  RC_ASSERT(sim::contains(old, plane.bounds()));
}

}  // namespace

TEST_CASE("a plane that is clipped keeps its ones in the half-plane, and no others") {
  CHECK(rc::check([] {
    const Pixels size = any_size();
    BitPlane plane(size.width(), size.height());
    const Pixels before = set_any(plane);
    check_clip(plane, before, any_half_plane(size));
  }));
}

TEST_CASE("a solid rectangle that several lines clip is what all of them leave") {
  CHECK(rc::check([] {
    const Pixels size = any_size();
    BitPlane plane(size.width(), size.height());
    plane.fill(plane.whole());
    for (int i = 0; i < 3; ++i) {
      const Pixels before = pixels_of(plane);
      check_clip(plane, before, any_half_plane(size));
    }
  }));
}

TEST_CASE("the greatest coefficients that are allowed clip without overflow") {
  BitPlane plane(129, 3);
  const std::int64_t most = (std::int64_t{1} << 61) / 129;
  plane.fill(plane.whole());
  // x >= 64, then x <= 64.
  sim::clip(plane, {most, 0, -64 * most});
  CHECK(plane.bounds() == sim::Rect{64, 0, 129, 3});
  sim::clip(plane, {-most, 0, 64 * most});
  CHECK(plane.bounds() == sim::Rect{64, 0, 65, 3});
  CHECK(sim::settle(plane) == 3);
}
