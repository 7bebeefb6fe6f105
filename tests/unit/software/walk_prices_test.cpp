// Costs of a ray's walk through directories, calculated by hand in clocks of an MC68000 programmed in assembly (prices
// in block_prices_test.cpp).

#include "hw/processors/processor.h"
#include "sim/software/space/directory.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Four squares across the x axis, two pairs of close ones.
software::Facets four_squares() {
  software::Facets facets;
  for (const double x : {0.0, 0.1, 9.9, 10.0}) {
    const auto number = static_cast<std::uint32_t>(facets.facets.size());
    facets.of_primitives.push_back(number);
    facets.facets.push_back({number, {}, facets.corners.size(), facets.corners.size() + 4});
    for (const auto& [y, z] : {std::pair{-1.0, -1.0}, std::pair{1.0, -1.0}, std::pair{1.0, 1.0}, std::pair{-1.0, 1.0}})
      facets.corners.push_back({x, y, z});
  }
  facets.of_primitives.push_back(4);
  return facets;
}

struct Seen final : software::CellVisitor {
  std::uint64_t cells = 0;
  std::uint64_t facets = 0;

  bool visit(const software::Cell& cell) override {
    ++cells;
    facets += cell.facets.size();
    return true;
  }
};

struct Walk {
  double clocks = 0;
  std::uint64_t cells = 0;
  std::uint64_t facets = 0;
};

/// A ray along the x axis, beside the walls that halve y and z.
Walk walk(const char* directory, std::uint32_t bucket_size) {
  const software::Facets facets = four_squares();
  const software::FacetShapes shapes(facets);
  const auto space = software::directory_of(directory).make(shapes, {bucket_size});
  Seen seen;
  software::Counting count;
  space->walk({{-5, 0.25, 0.25}, {1, 0, 0}, 0, std::numeric_limits<double>::infinity()}, seen, count);
  return {processors::clocks(count.done(), processors::load_processor("mc68000+compiler.factor=1000")), seen.cells,
          seen.facets};
}

constexpr double product = 4 * 70 + 3 * 8 + 2 * 4;
constexpr double quotient = 2 * 140 + 2 * 70 + 2 * 8;
constexpr double comparison = 16 + 6 + 8;

/// Reciprocals of the direction's components.
constexpr double begun = 3 * quotient;
/// A ray is clipped to the walls of a box: those across it take a product each, the others comparisons.
constexpr double clipped = (3 * 16 + 8 + 2 * 8 + 2 * product + 3 * comparison) + 2 * (3 * 16 + 8 + 2 * comparison);
constexpr double visited = 18 + 16;

/// A part of space is taken from the stack.
constexpr double taken = 3 * 16;
/// A wall that the ray crosses: it is read, the place is computed, and both sides are pushed.
constexpr double halved = 3 * 16 + 8 + 8 + product + 2 * comparison + 6 * 16;

}  // namespace

TEST_CASE("a ray through a k-d tree takes the hand-calculated clocks") {
  constexpr double node = 2 * 16 + 8;
  const Walk one_cell = walk("kd-tree", 8);
  CHECK(one_cell.cells == 1);
  CHECK(one_cell.clocks == begun + clipped + taken + node + visited);
  const Walk two_cells = walk("kd-tree", 2);
  REQUIRE(two_cells.cells == 2);
  CHECK(two_cells.facets == 4);
  CHECK(two_cells.clocks == begun + clipped + 3 * (taken + node) + halved + 2 * visited);
}
TEST_CASE("a ray through boxes around facets takes the hand-calculated clocks") {
  constexpr double met = 2 * 16;
  constexpr double node = 2 * 16 + 8;
  const Walk one_box = walk("bvh", 8);
  CHECK(one_box.cells == 1);
  CHECK(one_box.clocks == begun + clipped + met + node + visited);
  const Walk two_boxes = walk("bvh", 2);
  REQUIRE(two_boxes.cells == 2);
  // The second box is pushed onto a heap of one; removing the first restores the heap of the other.
  constexpr double put_on = comparison;
  constexpr double taken_off = 2 * comparison + 2 * 16;
  CHECK(two_boxes.clocks == begun + 3 * (clipped + met + node) + put_on + taken_off + 2 * visited);
}
TEST_CASE("a ray through EXCELL by points and by halves takes the hand-calculated clocks") {
  // The address of a place combines three tables; then its entry, its bucket, and one list of facets.
  constexpr double located = 3 * 16 + 2 * 8 + (8 + 2) + 8 + 8 + 16 + 8 + 2 * 12 + 16;
  // The departed cell has level 0 of five halvings per axis: its wall, and the distance to it.
  constexpr double left = 3 * (16 + 8) + (8 + 2 * 5) + 2 * 8 + 2 * product + comparison;
  const Walk by_points = walk("excell", 8);
  CHECK(by_points.cells == 1);
  CHECK(by_points.clocks == begun + clipped + 6 * product + located + left + visited);
  // Traversal by halving: tests whether the table entry is a directory, and compares its level with that of the range.
  constexpr double looked = (8 + 2) + 8 + 16 + 12 + 4 + 8;
  const Walk by_halves = walk("excell-recursive", 8);
  CHECK(by_halves.cells == 1);
  CHECK(by_halves.clocks == begun + clipped + taken + looked + 16 + visited);
  // The first of two cells is left through its wall to the next query point, which takes two places of the ray.
  const Walk two_points = walk("excell", 2);
  REQUIRE(two_points.cells == 2);
  constexpr double next_left = 3 * (16 + 8) + (8 + 2 * 4) + 2 * 8 + 2 * product + comparison;
  constexpr double stepped = 4 * product + 4 * 8 + 2 * comparison;
  CHECK(two_points.clocks == begun + clipped + 6 * product + 2 * (located + next_left + visited) + stepped);
  const Walk two_halves = walk("excell-recursive", 2);
  REQUIRE(two_halves.cells == 2);
  constexpr double wall = (8 + 2) + product + 2 * 8;
  CHECK(two_halves.clocks == begun + clipped + 3 * (taken + looked) + wall + halved + 2 * (16 + visited));
}
TEST_CASE("a ray through an octree of one cell is charged for no descent") {
  constexpr double left = 3 * (16 + 8) + 8 + 2 * 8 + 2 * product + comparison;
  const Walk one_cell = walk("octree", 8);
  CHECK(one_cell.cells == 1);
  const double clocks = one_cell.clocks - (begun + clipped + 6 * product + left + visited);
  // The wall's number is shifted by all levels of the octree, two clocks each.
  CHECK(clocks > 0);
  CHECK(clocks <= 2 * 16);
}
