#include "host/flat/parts.h"

#include "host/flat/combine.h"
#include "host/flat/hull.h"
#include "host/flat/made.h"
#include "host/flat/place.h"
#include "tests/support/test.h"
#include "tests/unit/flat/support.h"

using namespace csgsim;
using namespace flat;

namespace {

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

std::size_t reflex_corners(const Area& area) {
  std::size_t count = 0;
  for (const Outline& outline : area.outlines) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
      count += turn(outline[i], outline[(i + 1) % n], outline[(i + 2) % n]) < 0 ? 1U : 0U;
    }
  }
  return count;
}

/// Checks every guarantee except minimality: a reflex corner takes at most two cuts, and a hole one.
std::vector<Outline> checked_parts(const Area& area) {
  const std::vector<Outline> parts = flat::convex_parts(area);
  std::set<std::pair<double, double>> known;
  for (const Outline& outline : area.outlines) {
    for (const glm::dvec2& corner : outline) known.emplace(corner.x, corner.y);
  }
  CHECK(parts.size() <= 2 * reflex_corners(area) + area.outlines.size());
  double sum = 0;
  for (const Outline& part : parts) {
    const std::size_t n = part.size();
    REQUIRE(n >= 3);
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(known.contains({part[i].x, part[i].y}));
      CHECK(turn(part[i], part[(i + 1) % n], part[(i + 2) % n]) > -1e-9);
    }
    CHECK(flat::signed_area(part) > 0);
    sum += flat::signed_area(part);
  }
  CHECK(sum == doctest::Approx(flat::area_of(area)).epsilon(1e-12));
  CHECK(flat::difference(area, Area{parts}) <= 1e-6 * sum);
  return parts;
}

Area random_area(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> place(-10, 10);
  std::vector<glm::dvec2> points;
  for (std::size_t i = 0; i < count; ++i) points.emplace_back(place(random), place(random));
  return flat::polygon(points, {});
}

}  // namespace

TEST_CASE("a convex area is one part with the same corners") {
  for (const Area& area : {flat::square({3, 2}, false), flat::circle(7, {.fn = 100}), flat::circle(1e-3, {.fn = 3})}) {
    const std::vector<Outline> parts = checked_parts(area);
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].size() == area.outlines[0].size());
    CHECK(std::ranges::is_permutation(parts[0], area.outlines[0]));
  }
}

TEST_CASE("denormal coordinates become 0 in a convex part") {
  const Area area{{{{1e-320, 0}, {3, -1e-320}, {3, 2}, {1, 2}, {1, 1}, {0, 1}}}};
  double sum = 0;
  for (const Outline& part : flat::convex_parts(area)) sum += flat::signed_area(part);
  CHECK(sum == doctest::Approx(5).epsilon(1e-12));
  const Area around = flat::hull(std::vector<Area>{area});
  CHECK(around.outlines[0].size() == 5);
}

TEST_CASE("an area without outlines or size has no convex parts") {
  CHECK(flat::convex_parts({}).empty());
  CHECK(flat::convex_parts({{{{0, 0}, {1, 1}, {2, 2}}}}).empty());
  CHECK(flat::convex_parts({{{{0, 0}, {1, 1}}}}).empty());
  CHECK(flat::convex_parts({{{}}}).empty());
}

TEST_CASE("simple shapes have the minimum number of convex parts") {
  const Area ell = flat::polygon(std::array<glm::dvec2, 6>{{{0, 0}, {10, 0}, {10, 3}, {3, 3}, {3, 10}, {0, 10}}}, {});
  CHECK(checked_parts(ell).size() == 2);
  const Area plus = flat::unite(std::array{flat::square({6, 2}, true), flat::square({2, 6}, true)});
  CHECK(checked_parts(plus).size() == 3);
  const Area dart = flat::polygon(std::array<glm::dvec2, 4>{{{0, 0}, {10, 0}, {3, 3}, {0, 10}}}, {});
  CHECK(checked_parts(dart).size() == 2);
  // Three corners are reflex, (3, 5), (4, 2) and (5, 2), and a cut resolves at most two.
  const Area notched{{{{3, 6}, {3, 5}, {1, 4}, {4, 2}, {6, 0}, {6, 1}, {4, 6}, {5, 2}}}};
  CHECK(checked_parts(notched).size() == 3);
}

TEST_CASE("convex parts cover areas with holes and touching outlines") {
  const Area frame = flat::subtract(std::array{flat::square({8, 8}, true), flat::square({4, 4}, true)});
  CHECK(checked_parts(frame).size() == 4);
  const Area island = flat::unite(std::array{frame, flat::square({2, 2}, true)});
  CHECK(checked_parts(island).size() == 5);
  const Area ring = flat::subtract(std::array{flat::circle(5, {.fn = 64}), flat::circle(4, {.fn = 64})});
  CHECK(checked_parts(ring).size() <= 66);
  const Area twins =
      flat::polygon(std::array<glm::dvec2, 8>{{{0, 0}, {4, 0}, {4, 4}, {8, 4}, {8, 8}, {4, 8}, {4, 4}, {0, 4}}}, {});
  CHECK(checked_parts(twins).size() == 2);
  // Holes that touch each other and the border in single points.
  const std::vector<glm::dvec2> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 2}, {4, 4}, {2, 6}, {0, 4}, {6, 2}, {6, 6}};
  using Path = std::vector<std::uint32_t>;
  checked_parts(flat::polygon(points, std::array{Path{0, 1, 2, 3}, Path{4, 5, 6, 7}, Path{5, 8, 9}}));
}

TEST_CASE("outlines with a common side form one convex part") {
  const Area halves{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{4, 0}, {8, 0}, {8, 4}, {4, 4}}}};
  const std::vector<Outline> parts = flat::convex_parts(halves);
  REQUIRE(parts.size() == 1);
  CHECK(flat::signed_area(parts[0]) == 32);
  CHECK(parts[0].size() == 4);
}

TEST_CASE("an outline that winds twice is cut where it crosses itself") {
  Outline star;
  for (int i = 0; i < 5; ++i) {
    const double angle = i * 4 * std::acos(-1.0) / 5;
    star.emplace_back(std::cos(angle), std::sin(angle));
  }
  const std::vector<Outline> parts = flat::convex_parts({{star}});
  CHECK(parts.size() == 5);
  for (const Outline& part : parts) CHECK(part.size() == 3);
}

TEST_CASE("convex parts cover random areas including rotated and distant ones") {
  std::mt19937 random(14);
  for (int i = 0; i < 150; ++i) {
    CAPTURE(i);
    const Area area = random_area(random, 3 + static_cast<std::size_t>(i) / 4);
    if (area.empty()) continue;
    checked_parts(area);
    const double angle = i;
    const glm::dmat4 turned(std::cos(angle), std::sin(angle), 0, 0, -std::sin(angle), std::cos(angle), 0, 0,  //
                            0, 0, 1, 0, 1000, -500, 0, 1);
    checked_parts(flat::transformed(area, turned));
  }
}

TEST_CASE("an area has the same convex parts regardless of earlier calls") {
  std::mt19937 random(15);
  const Area area = random_area(random, 60);
  const std::vector<Outline> first = flat::convex_parts(area);
  for (int i = 0; i < 20; ++i) {
    flat::convex_parts(random_area(random, 40));
    CHECK(flat::convex_parts(area) == first);
  }
}
