#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

/// Near-parallel planes leave little between them: some pixels may be wrong, all within the bounds.
void check_within_bounds(const std::string& csg, std::uint64_t most_wrong, const Look& how = {}) {
  const Verdict verdict = look_obliquely(csg, how);
  CHECK(verdict.covered > 1000);
  CHECK(verdict.wrong <= most_wrong);
}

Look without_other_engines() {
  Look how;
  how.engines = false;
  return how;
}

}  // namespace

TEST_CASE("nearly parallel facets of a cylinder with 10000 sides are drawn correctly") {
  Look how = without_other_engines();
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const std::string round = cylinder({0, 0, 0}, 8, 5, 5, 10000);
    const Verdict verdict = look(round, whole(round, {0.61, -0.74, 0.52}, projection), how);
    CHECK(verdict.covered > 1000);
    CHECK(verdict.wrong == 0);
  }
}
TEST_CASE("a sphere of $fn = 1000 with half a million facets is drawn correctly") {
  Look how = without_other_engines();
  how.sampling.width = 48;
  how.sampling.height = 40;
  const std::string round = ball({0, 0, 0}, 10, csgsim::testing::cases(1000U, 300U));
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const Verdict verdict = look(round, whole(round, {0.61, -0.74, 0.52}, projection), how);
    CHECK(verdict.covered > 300);
    CHECK(verdict.wrong == 0);
  }
}
TEST_CASE("a sphere of $fn = 200 cut by a copy turned by 1e-7 is drawn correctly") {
  const std::string cut =
      subtract({ball({0, 0, 0}, 10, 200), with_transform(std::string(turns::hair), ball({0, 0, 0}, 10, 200))});
  Look how = without_other_engines();
  how.sampling.width = 64;
  how.sampling.height = 48;
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    look(cut, {{37, -45, 32}, {0, 0, 0}, projection}, how);
  }
}
TEST_CASE("a wall 1e-6 thick is visible or not within the bounds") {
  check_within_bounds(unite({box({0, 0, 0}, {10, 1e-6, 10}), box({0, 5, 0}, {10, 6, 4})}), 40000);
}
TEST_CASE("a wall 1e-6 thick between two cuts is drawn within the bounds") {
  check_within_bounds(
      subtract({box({0, 0, 0}, {10, 10, 10}), box({1, -1, 1}, {9, 5, 9}), box({1, 5.000001, 1}, {9, 11, 9})}), 40000);
}
TEST_CASE("a wall 1e-10 thick is visible or not within the bounds") {
  check_within_bounds(unite({box({0, 0, 0}, {10, 1e-10, 10}), box({0, 5, 0}, {10, 6, 4})}), 40000);
}
TEST_CASE("a wall thinner than the coincidence tolerance vanishes in picture and oracle") {
  CHECK(look_obliquely(unite({box({0, 0, 0}, {10, 1e-12, 10}), box({0, 5, 0}, {10, 6, 4})})).wrong == 0);
}
TEST_CASE("a gap of 1e-6 between two blocks is drawn within the bounds") {
  check_within_bounds(unite({box({0, 0, 0}, {8, 8, 8}), box({8.000001, 0, 0}, {16, 8, 8})}), 10);
  check_within_bounds(unite({box({0, 0, 0}, {8, 8, 8}), box({0, 8.000001, 0}, {8, 16, 8})}), 10);
}
TEST_CASE("a face 1e-9 in front of another is drawn within the bounds") {
  // Closer than a depth step: the picture may show either face.
  check_within_bounds(unite({box({0, 0, 0}, {8, 8, 8}), box({2, -1e-9, 2}, {6, 4, 6})}), 10000);
  check_within_bounds(subtract({box({0, 0, 0}, {8, 8, 8}), box({2, 1e-9, 2}, {6, 4, 6})}), 10000);
}
TEST_CASE("a needle a millionth as thick as it is long is drawn within the bounds") {
  check_within_bounds(unite({cylinder({0, 0, -10}, 20, 1e-5, 1e-5, 8), box({3, 3, 3}, {6, 6, 6})}), 10);
  check_within_bounds(unite({cylinder({0, 0, 0}, 20, 1e-5, 0, 8), box({3, 3, 3}, {6, 6, 6})}), 10);
}
TEST_CASE("a needle that points at the eye is drawn within the bounds") {
  const std::string needle = cylinder({0, 0, 0}, 1000, 3, 0, 30);
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    CHECK(look(needle, {{0, 0, 1100}, {0, 0, 0}, projection}).wrong <= 20);
    CHECK(look(needle, {{1, 2, 1100}, {1, 2, 0}, projection}).wrong <= 20);
    CHECK(look(needle, {{1, 2, -300}, {1, 2, 0}, projection}).wrong <= 20);
  }
}
TEST_CASE("slivers between planes that meet at 1e-3 to 1e-9 are drawn within the bounds") {
  for (const double height : {1e-2, 1e-4, 1e-6, 1e-8}) {
    CAPTURE(height);
    check_within_bounds(
        unite({tetrahedron({0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, height}), box({2, 2, -3}, {4, 4, -1})}), 40000);
  }
}
TEST_CASE("a solid minus itself turned by 1e-3 to 1e-9 leaves slivers within the bounds") {
  for (const double angle : {1e-1, 1e-3, 1e-5, 1e-7}) {
    CAPTURE(angle);
    const std::string cube = box({-5, -5, -5}, {5, 5, 5});
    const std::string csg = subtract({cube, with_transform(rotation(angle, 2 * angle), cube)});
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
      look(csg, {{37, -45, 32}, {0, 0, 0}, projection});
    }
  }
}
