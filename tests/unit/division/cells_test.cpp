#include "hw/division/cells.h"

#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/division/hand_models.h"

using namespace csgsim;
using namespace division;

namespace {

using Planes = std::vector<std::uint32_t>;

/// Half-spaces of one side over a rectangle, in the order of the planes.
struct Sides {
  DisplayModel model;
  std::vector<TestedHalfspace> side;
  Rectangle pixels;
};

Sides side_of(const std::vector<Plane>& planes, bool forward, const Rectangle& pixels, unsigned fraction_bits = 0) {
  Sides made{testing::empty_model(), {}, pixels};
  made.model.planes = planes;
  made.model.fraction_bits = fraction_bits;
  for (std::uint32_t i = 0; i < planes.size(); ++i)
    made.side.push_back(division::test_corners(made.model, {0, i, {i, forward, 0}, planes[i]}, pixels));
  return made;
}

struct Kept {
  Planes planes;
  std::uint64_t tests = 0;
  bool operator==(const Kept&) const = default;
};

Kept kept_of(const Sides& made, std::uint64_t tests) {
  Kept kept{{}, tests};
  for (const TestedHalfspace& one : made.side) kept.planes.push_back(one.halfspace.plane);
  return kept;
}

Kept extremes(Sides made) {
  division::PlainDatapath path(made.model);
  division::remove_hidden_halfspaces(path, made.side, made.pixels);
  return kept_of(made, path.take_counts().cells);
}

Kept by_leaders(Sides made) {
  division::PlainDatapath path(made.model);
  division::remove_behind_leaders(path, made.side, made.pixels);
  return kept_of(made, path.take_counts().cells);
}

constexpr Rectangle row{0, 0, 10, 0};

std::int64_t value(const Plane& plane, std::int32_t x, std::int32_t y) { return plane.a * x + plane.b * y + plane.c; }

/// Planes that are within a depth step of the extreme at some pixel.
Planes near_somewhere(const Sides& made, bool forward) {
  const std::vector<Plane>& planes = made.model.planes;
  const std::int64_t sign = forward ? 1 : -1;
  Planes near;
  for (std::uint32_t i = 0; i < planes.size(); ++i) {
    bool is_near = false;
    for (std::int32_t y = made.pixels.y0; y <= made.pixels.y1; ++y) {
      for (std::int32_t x = made.pixels.x0; x <= made.pixels.x1; ++x) {
        is_near = is_near || std::none_of(planes.begin(), planes.end(), [&](const Plane& other) {
                    return sign * (value(other, x, y) - value(planes[i], x, y)) >= std::int64_t{1}
                                                                                       << made.model.fraction_bits;
                  });
      }
    }
    if (is_near) near.push_back(i);
  }
  return near;
}

Sides any_side(bool forward) {
  const auto any = [](int low, int high) { return *rc::gen::inRange(low, high + 1); };
  std::vector<Plane> planes(static_cast<std::size_t>(any(1, 12)));
  for (Plane& plane : planes) plane = {false, any(-30, 30), any(-30, 30), any(-500, 500)};
  const int x = any(0, 9);
  const int y = any(0, 9);
  return side_of(planes, forward, {x, y, x + any(0, 40), y + any(0, 40)}, static_cast<unsigned>(any(0, 5)));
}

}  // namespace

TEST_CASE("of two fronts the one nearer at all corners is inactive (thesis fig. 7.5a)") {
  CHECK(extremes(side_of({{false, 1, 0, 2}, {false, 0, 0, 20}}, true, row)) == Kept{{1}, 2});
}

TEST_CASE("two fronts that cross between the corners are both active (thesis fig. 7.5b)") {
  CHECK(extremes(side_of({{false, 1, 0, 2}, {false, -1, 0, 9}}, true, row)) == Kept{{0, 1}, 2});
}

TEST_CASE("of two backs the one farther at all corners is inactive (thesis table 7.1)") {
  CHECK(extremes(side_of({{false, 1, 0, 2}, {false, 0, 0, 20}}, false, row)) == Kept{{0}, 2});
  CHECK(extremes(side_of({{false, 1, 0, 2}, {false, -1, 0, 9}}, false, row)) == Kept{{0, 1}, 2});
}

TEST_CASE("the divider drops a half-space only if another is a whole depth step beyond it") {
  const Sides made = side_of({{false, 0, 0, 16}, {false, 0, 0, 23}, {false, 0, 0, 24}}, true, row, 3);
  CHECK(extremes(made) == Kept{{1, 2}, 3});
  CHECK(by_leaders(made) == Kept{{1, 2}, 3});
}

TEST_CASE("the divider keeps all of several coincident half-spaces") {
  CHECK(extremes(side_of({{false, 1, 0, 2}, {false, 1, 0, 2}}, true, row)) == Kept{{0, 1}, 2});
}

TEST_CASE("the divider tests a single half-space once and an empty side not at all") {
  CHECK(extremes(side_of({{false, 1, 0, 2}}, true, row)) == Kept{{0}, 1});
  CHECK(extremes(side_of({}, true, row)) == Kept{});
}

TEST_CASE("half-spaces that no leader is beyond at all corners are compared in quarters") {
  // Values at the corners of the row: 20 and -10, -10 and 20, 4 and 4; in columns 0 to 7: 20 and -1, -10 and 11; in 4
  // to 7: 8 and -1, 2 and 11. In 0 to 3 the first is at least 11, in 4 and 5 it is 5; in 6 and 7 the second is 8, and
  // in 8 to 10 it is 14.
  const Sides made = side_of({{false, -3, 0, 20}, {false, 3, 0, -10}, {false, 0, 0, 4}}, true, row);
  CHECK(by_leaders(made) == Kept{{0, 1, 2}, 3});
  const Kept kept = extremes(made);
  CHECK(kept.planes == Planes{0, 1});
  // All three are tested in the row and in columns 0 to 7, 0 to 3, 4 to 7, 4 and 5, 6 and 7, and 8 to 10.
  CHECK(kept.tests == 7 * 3);
}

TEST_CASE("the divider keeps the half-spaces within a depth step of the extreme somewhere") {
  CHECK(rc::check([] {
    const bool forward = *rc::gen::arbitrary<bool>();
    const Sides made = any_side(forward);
    RC_ASSERT(extremes(made).planes == near_somewhere(made, forward));
  }));
}

TEST_CASE("the divider tests a half-space at most once per cell of its rectangle") {
  CHECK(rc::check([] {
    const Sides made = any_side(true);
    std::uint64_t cells = 1;
    for (std::int32_t size = 64; size > 1; size /= 2) {
      const auto along = [&](std::int32_t first, std::int32_t last) {
        return static_cast<std::uint64_t>((last - first) / (size / 2) + 1);
      };
      cells += along(made.pixels.x0, made.pixels.x1) * along(made.pixels.y0, made.pixels.y1);
    }
    RC_ASSERT(extremes(made).tests <= made.side.size() * cells);
  }));
}

TEST_CASE("dropping half-spaces behind leading ones first does not change the kept ones") {
  CHECK(rc::check([] {
    const Sides made = any_side(true);
    Sides first = made;
    division::PlainDatapath path(first.model);
    division::remove_behind_leaders(path, first.side, first.pixels);
    RC_ASSERT(extremes(first).planes == extremes(made).planes);
  }));
}
