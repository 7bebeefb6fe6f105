#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

constexpr glm::dvec3 oblique{0.61, -0.74, 0.9};

/// Number of solids in the largest unions and differences.
const int most = csgsim::testing::cases(10'000, 2'000);

/// A block on a grid of 100 columns that may extend through a plate of thickness 4.
std::string peg(int index, double low, double high) {
  return box({index % 100, index / 100, low}, {index % 100 + 0.5, index / 100 + 0.5, high});
}

std::vector<std::string> plate_and_pegs(int count) {
  std::vector<std::string> parts{box({0, 0, 0}, {100, 100, 4})};
  for (int i = 0; i < count; ++i) parts.push_back(peg(i, 1, 6));
  return parts;
}

/// Nested to the left: (((plate op peg) op peg) ...).
std::string left_deep(int count, const std::vector<std::string>& operators) {
  std::string head;
  std::string tail = box({0, 0, 0}, {100, 100, 4});
  for (int i = count; i-- > 0;) head += operators[static_cast<std::size_t>(i) % operators.size()] + "(){\n";
  for (int i = 0; i < count; ++i) tail += peg(i, i % 2 == 0 ? 1 : -1, 6) + "}\n";
  return head + tail;
}

/// Nested to the right: block - (block - (block - ...)), each slightly smaller.
std::string right_deep(int count) {
  std::string csg;
  for (int i = 0; i < count; ++i) csg += "difference(){\n" + box(glm::dvec3(0.01 * i), {50, 50, 50 - 0.01 * i});
  csg += box({20, 20, 0}, {50, 50, 30});
  for (int i = 0; i < count; ++i) csg += "}\n";
  return csg;
}

void check_both_ways(const std::string& csg, std::uint64_t most_wrong, bool engines = true) {
  Look how;
  how.engines = engines;
  how.memory_bits = 200;
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const Verdict verdict = look(csg, whole(csg, oblique, projection), how);
    CHECK(verdict.wrong <= most_wrong);
    CHECK(verdict.covered > 500);
  }
}

/// cube - count * (sphere and cylinder).
std::string dimpled(int count) {
  std::vector<std::string> parts{box({0, 0, 0}, {100, 100, 20})};
  for (int i = 0; i < count; ++i) {
    const double x = 5 + 10 * (i % 10);
    const double y = 5 + 10 * (i / 10);
    parts.push_back(intersect({ball({x, y, 20}, 4.5, 12), cylinder({x, y, 10}, 20, 3.5, 3.5, 12)}));
  }
  return subtract(parts);
}

}  // namespace

TEST_CASE("a difference with more than 255 subtracted solids is drawn correctly") {
  check_both_ways(subtract(plate_and_pegs(300)), 0);
  check_both_ways(subtract(plate_and_pegs(1000)), 0, false);
}
TEST_CASE("256 overlapping subtracted solids are drawn correctly") {
  std::vector<std::string> parts{box({-30, -30, -30}, {30, 30, 30})};
  for (int i = 0; i < 256; ++i)
    parts.push_back(with_transform(rotation(7.0 * i, 3.0 * i), box({18, -20, -4}, {40, 20, 4})));
  check_both_ways(subtract(parts), 10, false);
}
TEST_CASE("a cube minus 1 to 100 intersections of sphere and cylinder is drawn correctly") {
  for (const int count : {1, 2, 5, 11, 12, 31, 32}) {
    CAPTURE(count);
    check_both_ways(dimpled(count), 0);
  }
  check_both_ways(dimpled(100), 0, false);
}
TEST_CASE("a union of thousands of solids is drawn correctly") {
  check_both_ways(unite(plate_and_pegs(most)), 2, false);
}
TEST_CASE("a difference of thousands of solids is drawn correctly") {
  check_both_ways(subtract(plate_and_pegs(most)), 2, false);
}
TEST_CASE("an intersection of 300 solids that each remove a little is drawn correctly") {
  std::vector<std::string> parts;
  for (int i = 0; i < 300; ++i)
    parts.push_back(with_transform(rotation(37.0 * i, 61.0 * i), box({-50, -50, -50}, {50, 50, 30})));
  check_both_ways(intersect(parts), 10, false);
}
TEST_CASE("a tree of unions 10000 deep is drawn correctly") { check_both_ways(left_deep(10000, {"union"}), 5, false); }
TEST_CASE("a tree of differences 10000 deep is drawn correctly") {
  check_both_ways(left_deep(10000, {"difference"}), 5, false);
}
TEST_CASE("a tree of alternating unions and differences 10000 deep is drawn correctly") {
  check_both_ways(left_deep(10000, {"union", "difference"}), 5, false);
}
TEST_CASE("a tree nested to the right with overlaps of all solids is drawn correctly") {
  check_both_ways(right_deep(40), 10);
  check_both_ways(right_deep(300), 10, false);
}
