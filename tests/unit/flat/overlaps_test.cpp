#include "host/flat/overlaps.h"

#include "host/flat/clipping.h"
#include "tests/support/test.h"

using namespace csgsim;
using ClipperLib::Path;
using ClipperLib::Paths;

namespace {

/// Even-odd test with the number of sides above the point. No corner has the same x.
bool is_in(const Paths& paths, double x, double y) {
  bool inside = false;
  for (const Path& path : paths) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const auto& a = path[i];
      const auto& b = path[(i + 1) % path.size()];
      const auto ax = static_cast<double>(a.X);
      const auto bx = static_cast<double>(b.X);
      if ((ax > x) == (bx > x)) continue;
      const auto ay = static_cast<double>(a.Y);
      const double height = ay + (static_cast<double>(b.Y) - ay) * (x - ax) / (bx - ax);
      if (height > y) inside = !inside;
    }
  }
  return inside;
}

void check_same(const Paths& paths, const Paths& made, int size) {
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      CAPTURE(x);
      CAPTURE(y);
      CHECK(is_in(paths, x + 0.37, y + 0.41) == is_in(made, x + 0.37, y + 0.41));
    }
  }
}

}  // namespace

TEST_CASE("polygon paths without overlapping sides stay unchanged") {
  const Paths paths{{{0, 0}, {9, 0}, {9, 0}, {9, 9}, {0, 9}}, {{2, 2}, {4, 2}, {3, 5}}, {{9, 9}, {12, 9}, {12, 12}}};
  CHECK(flat::remove_coincident_sides(paths) == paths);
  CHECK(flat::remove_coincident_sides({}).empty());
  // A side begins where another one ends.
  const Paths touching{{{0, 0}, {4, 0}, {4, 4}}, {{4, 0}, {8, 0}, {8, -4}}};
  CHECK(flat::remove_coincident_sides(touching) == touching);
}

TEST_CASE("sides that coincide an even number of times vanish and others remain once") {
  const Path triangle{{0, 0}, {9, 0}, {0, 9}};
  const Path back{{0, 0}, {0, 9}, {9, 0}};
  CHECK(flat::remove_coincident_sides({triangle, triangle}).empty());
  CHECK(flat::remove_coincident_sides({triangle, back}).empty());
  const Paths once = flat::remove_coincident_sides({triangle, back, triangle});
  REQUIRE(once.size() == 1);
  CHECK(once[0].size() == 3);
  CHECK(std::abs(ClipperLib::Area(once[0])) == doctest::Approx(40.5));
  // A spike that runs out and back.
  const Paths spiked = flat::remove_coincident_sides({{{0, 0}, {9, 0}, {20, 0}, {9, 0}, {0, 9}}});
  CHECK(spiked.size() == 1);
  check_same({triangle}, spiked, 25);
}

TEST_CASE("removing partly overlapping sides does not change the interior of a path") {
  // Two boxes with a common side, on the x axis, the y axis and an oblique line.
  check_same({{{0, 0}, {8, 0}, {8, 4}, {0, 4}}, {{2, 4}, {6, 4}, {6, 9}, {2, 9}}},
             flat::remove_coincident_sides({{{0, 0}, {8, 0}, {8, 4}, {0, 4}}, {{2, 4}, {6, 4}, {6, 9}, {2, 9}}}), 12);
  check_same({{{0, 0}, {4, 0}, {4, 8}, {0, 8}}, {{4, 2}, {9, 2}, {9, 6}, {4, 6}}},
             flat::remove_coincident_sides({{{0, 0}, {4, 0}, {4, 8}, {0, 8}}, {{4, 2}, {9, 2}, {9, 6}, {4, 6}}}), 12);
  check_same({{{0, 0}, {8, 4}, {4, 9}}, {{2, 1}, {6, 3}, {7, 0}}},
             flat::remove_coincident_sides({{{0, 0}, {8, 4}, {4, 9}}, {{2, 1}, {6, 3}, {7, 0}}}), 12);
}

TEST_CASE("random grid paths keep their interior and lose overlapping sides") {
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round) {
    Paths paths(2);
    for (Path& path : paths) {
      for (int i = 0; i < 12; ++i)
        path.emplace_back(static_cast<ClipperLib::cInt>(random() % 6), static_cast<ClipperLib::cInt>(random() % 6));
    }
    const Paths made = flat::remove_coincident_sides(paths);
    check_same(paths, made, 6);
    CHECK(flat::remove_coincident_sides(made) == made);
  }
}

TEST_CASE("extreme coordinates do not overflow where sides overlap") {
  const ClipperLib::cInt far = static_cast<ClipperLib::cInt>(1e12 * flat::clipper_scale);
  const Path large{{-far, -far}, {far, -far + 1}, {far - 1, far}};
  CHECK(flat::remove_coincident_sides({large, large}).empty());
  CHECK(flat::remove_coincident_sides({large}) == Paths{large});
}

TEST_CASE("a path traversed four times is empty and costs less work than once") {
  std::mt19937 random(2);
  Path once;
  for (int i = 0; i < 400; ++i)
    once.emplace_back(static_cast<ClipperLib::cInt>(random() % 1000), static_cast<ClipperLib::cInt>(random() % 1000));
  Path often;
  for (int i = 0; i < 4; ++i) often.insert(often.end(), once.begin(), once.end());
  const Work work(1'000'000);
  CHECK(flat::even_odd_area({often}, work).empty());
  CHECK_THROWS_AS(flat::even_odd_area({once}, work.with_zero_count()), WorkError);
}
