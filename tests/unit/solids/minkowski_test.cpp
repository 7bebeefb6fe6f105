#include "host/solids/minkowski.h"

#include "host/solids/hull.h"
#include "host/solids/hull_faces.h"
#include "tests/support/test.h"
#include "tests/unit/solids/support.h"

using namespace csgsim;

namespace {

model::Polyhedron cube(double side) {
  const std::optional<model::Polyhedron> piece = solids::hull_piece(testing::box({0, 0, 0}, {side, side, side}).points);
  REQUIRE(piece);
  return *piece;
}

/// Checks that the only piece is a cube with this side.
void check_only_cube(const solids::Pieces& pieces, double side) {
  REQUIRE(pieces.size() == 1);
  const testing::Extent extent = testing::extent_of(pieces.front().points);
  CHECK(extent.low == glm::dvec3(0));
  CHECK(extent.high == glm::dvec3(side));
}

}  // namespace

TEST_CASE("a Minkowski sum drops duplicate pieces and pieces inside others") {
  const solids::Pieces added{cube(1)};
  const model::Polyhedron large = cube(4);
  const model::Polyhedron small = cube(2);
  for (const solids::Pieces& pieces :
       {solids::Pieces{large, large}, {large, large, large}, {large, small, large}, {small, large, large}}) {
    const std::vector<solids::Pieces> operands{pieces, added};
    check_only_cube(solids::minkowski(operands), 5);
  }
}

TEST_CASE("the sorted corners of a hull exclude a point in the middle of an edge") {
  solids::Mesh cube{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 0}},
                    {{0, 3, 8},
                     {8, 3, 2},
                     {8, 2, 1},
                     {4, 5, 6},
                     {4, 6, 7},
                     {0, 8, 4},
                     {8, 5, 4},
                     {8, 1, 5},
                     {1, 2, 6},
                     {1, 6, 5},
                     {2, 3, 7},
                     {2, 7, 6},
                     {3, 0, 4},
                     {3, 4, 7}}};
  const solids::Mesh sorted = solids::canonical_hull(cube);
  CHECK(sorted.points.size() == 8);
  CHECK(sorted.faces.size() == 12);
}
