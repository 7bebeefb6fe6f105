#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

/// Model units per pixel in an orthographic picture of `rows` rows from that distance.
double pixel_size(double distance, std::uint32_t rows) {
  return 2.0 * std::tan(11.25 * std::numbers::pi / 180.0) * distance / rows;
}

}  // namespace

TEST_CASE("vertices and edges on pixel centres are within the bounds orthographically") {
  const Look how;
  const double pixel = pixel_size(60, how.sampling.height);
  // Corners at pixel centres of the odd picture, up to rounding of doubles.
  const std::string csg = unite({box({-20 * pixel, 0, -10 * pixel}, {-5 * pixel, 5, 12 * pixel}),
                                 box({-5 * pixel, 0, -10 * pixel}, {7 * pixel, 3, 12 * pixel}),
                                 subtract({box({7 * pixel, 0, 0}, {27 * pixel, 3, 20 * pixel}),
                                           box({10 * pixel, 0, 5 * pixel}, {20 * pixel, 3, 15 * pixel})})});
  const Verdict verdict = look(csg, {{0, -60, 0}, {0, 0, 0}, Projection::orthographic});
  CHECK(verdict.covered > 600);
  // Only pixels on the outlines may be wrong.
  CHECK(verdict.wrong < 300);
}
TEST_CASE("vertices and edges on pixel centres are within the bounds in perspective") {
  const Look how;
  const double pixel = pixel_size(60, how.sampling.height);
  // The front faces are at the distance at which a pixel has that size.
  const std::string csg = unite(
      {box({-20 * pixel, 0, -10 * pixel}, {-5 * pixel, 5, 12 * pixel}),
       box({-5 * pixel, 0, -10 * pixel}, {7 * pixel, 3, 12 * pixel}),
       tetrahedron({10 * pixel, 0, 0}, {30 * pixel, 0, 0}, {20 * pixel, 0, 10 * pixel}, {20 * pixel, 9, 4 * pixel})});
  const Verdict verdict = look(csg, {{0, -60, 0}, {0, 0, 0}, Projection::perspective});
  CHECK(verdict.covered > 600);
  CHECK(verdict.wrong < 300);
}
TEST_CASE("a vertex exactly in the middle of the picture is drawn correctly") {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    for (unsigned i = 0; i < 8; ++i) {
      const glm::dvec3 low((i & 1U) != 0 ? -8 : 0, (i & 2U) != 0 ? -8 : 0, (i & 4U) != 0 ? -8 : 0);
      // One corner of the cube is exactly the centre of view.
      const std::string cube = box(low, low + 8.0);
      CHECK(look(cube, {{0, -64, 0}, {0, 0, 0}, projection}).wrong == 0);
      CHECK(look(cube, {{0, 0, 64}, {0, 0, 0}, projection}).wrong == 0);
      // The vertical outline is on the pixel centres of half a column, where the solid has no thickness.
      CHECK(look(cube, {{48, -48, 24}, {0, 0, 0}, projection}).wrong < 48);
    }
  }
}
TEST_CASE("a vertical edge exactly in the middle column is drawn correctly") {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    for (const glm::dvec3 low : {glm::dvec3(0, 0, -4), glm::dvec3(-8, 0, -4), glm::dvec3(-8, -8, -4)}) {
      CHECK(look(box(low, low + 8.0), {{0, -64, 0}, {0, 0, 0}, projection}).wrong == 0);
      CHECK(look(box(low, low + 8.0), {{48, -48, 0}, {0, 0, 0}, projection}).wrong == 0);
    }
  }
}
TEST_CASE("a grid of cubes with corners near pixel centres shows no cracks") {
  const Look how;
  const double pixel = pixel_size(60, how.sampling.height);
  std::vector<std::string> cubes;
  for (int x = -3; x < 3; ++x) {
    for (int z = -3; z < 3; ++z) {
      cubes.push_back(box({6 * x * pixel, 0, 6 * z * pixel}, {6 * (x + 1) * pixel, 2, 6 * (z + 1) * pixel}));
    }
  }
  const std::string csg = unite(cubes);
  const csgsim::view::Camera camera{{0, -60, 0}, {0, 0, 0}, Projection::orthographic};
  look(csg, camera);
  const csgsim::observe::Frame frame = picture_of(csg, camera);
  for (int y = -17; y <= 17; ++y) {
    for (int x = -17; x <= 17; ++x) {
      const int row = static_cast<int>(frame.height / 2) + y;
      const int column = static_cast<int>(frame.width / 2) + x;
      REQUIRE(frame.owner[static_cast<std::size_t>(row) * frame.width + static_cast<std::size_t>(column)] !=
              csgsim::observe::no_owner);
    }
  }
}
