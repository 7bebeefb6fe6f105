#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

const std::string bracket =
    subtract({unite({box({0, 0, 0}, {10, 6, 2}), box({0, 0, 0}, {2, 6, 8})}), cylinder({6, 3, 0}, 2, 2, 2, 20)});

constexpr glm::dvec3 oblique{0.61, -0.74, 0.52};

}  // namespace

TEST_CASE("models of size 1e-6 and 1e6 are drawn as one of size 1") {
  for (const double size : {1e-6, 1.0, 1e6}) {
    const Verdict verdict = look_obliquely(with_transform(scaling(glm::dvec3(size)), bracket));
    CHECK(verdict.wrong == 0);
    CHECK(verdict.covered > 10000);
  }
}
TEST_CASE("solids of sizes from 1e-6 to 1e6 in one scene are drawn correctly from nearby") {
  std::vector<std::string> side_by_side;
  for (int exponent = -6; exponent <= 6; ++exponent) {
    const double size = std::pow(10.0, exponent);
    side_by_side.push_back(
        with_transform(translation({size, 0, 0}), with_transform(scaling(glm::dvec3(0.3 * size)), bracket)));
  }
  const std::string csg = unite(side_by_side);
  for (int exponent = -6; exponent <= 6; exponent += 2) {
    const double size = std::pow(10.0, exponent);
    CAPTURE(size);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
      const glm::dvec3 centre(1.5 * size, 0, 0);
      Look how;
      // The default near plane would be at 1/256 of the distance to the farthest solid.
      how.sampling.near = 4.0 * size;
      const Verdict verdict = look(csg, {centre + 10.0 * size * oblique, centre, projection}, how);
      // Solids smaller than 1e-11 of the scene, 6e-5, have vanished.
      if (size >= 1e-2) CHECK(verdict.covered > 100);
    }
  }
}
TEST_CASE("a model 1e6 away from the origin is drawn correctly") {
  for (const glm::dvec3 away : {glm::dvec3(1e6, 0, 0), glm::dvec3(-1e6, 1e6, 1e6), glm::dvec3(333333.3, -7e5, 1e6)}) {
    const Verdict verdict = look_obliquely(with_transform(translation(away), bracket));
    CHECK(verdict.covered > 10000);
    CHECK(verdict.wrong == 0);
  }
}
TEST_CASE("coincident faces 1e6 away from the origin are still coincident") {
  const std::string there = translation({1e6, -1e6, 1e6});
  CHECK(look_obliquely(with_transform(there, subtract({bracket, bracket}))).covered == 0);
  CHECK(look_obliquely(with_transform(there, unite({box({0, 0, 0}, {8, 8, 8}), box({8, 0, 0}, {16, 8, 8})}))).wrong ==
        0);
}
TEST_CASE("a far plane a million times beyond the near plane has errors within the bounds") {
  const std::string csg = unite({box({-1, 2, -1}, {1, 3, 0}), box({-2e6, 1.5e6, -1e6}, {2e6, 2e6, 0})});
  for (const double near : {2.0, 0.5, 2000.0}) {
    CAPTURE(near);
    Look how;
    how.sampling.near = near;
    CHECK(look(csg, {{0.1, 0, 0.7}, {0, 10, 0}, Projection::perspective}, how).covered > 1000);
  }
  CHECK(look(csg, {{0.1, 0, 0.7}, {0, 10, 0}, Projection::perspective}).covered > 1000);
  CHECK(look(csg, {{0.1, 0, 0.7}, {0, 10, 0}, Projection::orthographic}).covered > 1000);
}
TEST_CASE("a camera a million model sizes away sees the model correctly") {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    // The whole model covers about one pixel.
    look(bracket, {1e7 * oblique, {5, 3, 2}, projection});
  }
}
TEST_CASE("pictures with few depth bits and no fraction bits have errors within the bounds") {
  for (const unsigned z_bits : {4U, 8U, 12U, 30U}) {
    for (const unsigned fraction_bits : {0U, 4U, 20U}) {
      CAPTURE(z_bits);
      CAPTURE(fraction_bits);
      Look how;
      how.memory_bits = 100;
      how.sampling.z_bits = z_bits;
      how.sampling.fraction_bits = fraction_bits;
      const Verdict verdict = look_obliquely(bracket, how);
      if (z_bits == 30 && fraction_bits == 20) CHECK(verdict.wrong == 0);
    }
  }
}
