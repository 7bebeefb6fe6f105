#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

constexpr Projection orthographic = Projection::orthographic;
constexpr Projection perspective = Projection::perspective;

const std::string room = subtract({box({-10, -10, -10}, {10, 10, 10}), box({-8, -8, -8}, {8, 8, 8}),
                                   cylinder({0, 0, -20}, 40, 3, 3, 16), box({2, 7, -3}, {5, 11, 3})});

std::uint64_t total(const csgsim::judges::Truth& truth) { return truth.owner.size(); }

csgsim::judges::Truth truth_at(const std::string& csg, const csgsim::view::Camera& camera) {
  const Look how;
  return truth_of(compile_text(csg, {camera, how.sampling, how.memory_bits}));
}

}  // namespace

TEST_CASE("an eye inside a solid sees its cap at the near plane everywhere") {
  const std::string block = unite({box({-50, -50, -50}, {50, 50, 50}), box({20, 20, 20}, {70, 70, 70})});
  const Verdict verdict = look(block, {{1, 2, 3}, {1, 40, 5}, perspective});
  CHECK(verdict.wrong == 0);
  CHECK(verdict.covered == total(truth_at(block, {{1, 2, 3}, {1, 40, 5}, perspective})));
  const csgsim::observe::Frame frame = picture_of(block, {{1, 2, 3}, {1, 40, 5}, perspective});
  for (const std::uint32_t depth : frame.depth) REQUIRE(depth == 0);
}
TEST_CASE("an eye inside a room sees its walls") {
  CHECK(look(room, {{1, -5, 2}, {0.5, 8, 1}, perspective}).wrong == 0);
  CHECK(look(room, {{-7, -7, -7}, {8, 8, 8}, perspective}).wrong <= 1);
  CHECK(look(room, {{1, -5, 2}, {0.5, 8, 1}, perspective}).covered > 8000);
}
TEST_CASE("an eye inside a hole looks through it") {
  CHECK(look(room, {{0.5, 0.25, -9.3}, {0.4, 0.1, 9}, perspective}).wrong == 0);
  CHECK(look(room, {{0.5, 0.25, 9.5}, {0.4, 0.1, -9}, perspective}).wrong <= 1);
}
TEST_CASE("an eye on the axis of a hole sees it correctly along its edges") {
  CHECK(look(room, {{0, 0, -9.5}, {0, 0, 9}, perspective}).covered > 0);
  CHECK(look(room, {{0, 0, -60}, {0, 0, 9}, perspective}).covered > 1000);
  CHECK(look(room, {{0, 0, -60}, {0, 0, 9}, orthographic}).covered > 1000);
}
TEST_CASE("an eye in the plane of one face or two sees the block correctly") {
  const std::string block = box({-5, 0, -5}, {5, 10, 5});
  CHECK(look(block, {{-5, -30, 0}, {0, 5, 0}, perspective}).wrong == 0);
  CHECK(look(block, {{0.3, -30, 5}, {0, 5, 0}, perspective}).covered > 1000);
  CHECK(look(block, {{-5, -30, 5}, {1, 5, 0}, perspective}).covered > 1000);
}
TEST_CASE("an eye on a face sees the cut inside or the outside depending on its direction") {
  const std::string block = box({-5, 0, -5}, {5, 10, 5});
  const csgsim::view::Camera inwards{{0.2, 0, 0.1}, {0, 5, 0.3}, perspective};
  CHECK(look(block, inwards).covered == total(truth_at(block, inwards)));
  CHECK(look(block, {{0.2, 0, 0.1}, {0, -5, 0.3}, perspective}).covered == 0);
}
TEST_CASE("an eye at a vertex or on an edge sees the solid within the bounds") {
  const std::string block = unite({box({0, 0, 0}, {10, 10, 10}), box({-10, 3, 0}, {0, 13, 8})});
  look(block, {{0, 0, 0}, {5, 5, 5}, perspective});
  look(block, {{0, 0, 5}, {5, 5, 5}, perspective});
  look(block, {{0, 0, 5}, {-5, 8, 5}, perspective});
}
TEST_CASE("a face one pixel from the eye fills the picture") {
  const std::string block = box({-5, 0, -5}, {5, 10, 5});
  const csgsim::view::Camera camera{{0.2, -0.004, 0.1}, {0.2, 5, 0.1}, perspective};
  const Verdict verdict = look(block, camera);
  CHECK(verdict.wrong == 0);
  CHECK(verdict.covered == total(truth_at(block, camera)));
}
TEST_CASE("an eye close to the plane of a face sees it foreshortened to the horizon") {
  const std::string floor = unite({box({-1000, 0, -1}, {1000, 2000, 0}), box({5, 40, 0}, {9, 44, 6})});
  for (const double height : {1.0, 1e-2, 1e-4, 1e-6}) {
    CAPTURE(height);
    CHECK(look(floor, {{0.1, -1, height}, {0, 50, height}, perspective}).covered > 0);
    CHECK(look(floor, {{0.1, -1, height}, {0, 50, 0}, perspective}).covered > 0);
  }
}
TEST_CASE("solids behind the eye are invisible in perspective but not orthographically") {
  const std::string behind = unite({box({-5, 20, -5}, {5, 30, 5}), box({-5, -40, -5}, {5, -30, 2})});
  CHECK(look(behind, {{0, 40, 0}, {0, 60, 0}, perspective}).covered == 0);
  CHECK(look(behind, {{0, 0, 0.3}, {1, 60, 0}, perspective}).wrong == 0);
  CHECK(look(behind, {{0.3, 100, 0.2}, {0, 160, 0}, orthographic}).covered > 1000);
}
TEST_CASE("a near plane through the model caps solids but not holes") {
  Look how;
  for (const double near : {21.0, 25.0, 31.0, 37.0}) {
    CAPTURE(near);
    how.sampling.near = near;
    const Verdict verdict = look(room, {{4, -31, 3}, {0, 0, 0}, perspective}, how);
    CHECK(verdict.wrong == 0);
    CHECK(verdict.covered > 2000);
  }
}
TEST_CASE("views straight down and up are drawn correctly") {
  for (const Projection projection : {orthographic, perspective}) {
    const std::string skew = with_transform(rotation(12, 34), room);
    CHECK(look(skew, {{1, 2, 70}, {1, 2, 0}, projection}).wrong == 0);
    CHECK(look(skew, {{1, 2, -70}, {1, 2, 0}, projection}).wrong == 0);
    CHECK(look(skew, {{1, 2 + 1e-9, 70}, {1, 2, 0}, projection}).wrong == 0);
  }
}
TEST_CASE("a camera rolled about its view direction sees the model correctly") {
  const std::string skew = with_transform(rotation(12, 34), room);
  for (const glm::dvec3 degrees : {glm::dvec3(55, 20, 25), glm::dvec3(90, 90, 0), glm::dvec3(180, 0, 33)}) {
    for (const Projection projection : {orthographic, perspective}) {
      csgsim::view::Camera camera = csgsim::view::gimbal_camera({1, 2, 0}, degrees, 70);
      camera.projection = projection;
      CHECK(look(skew, camera).wrong == 0);
    }
  }
}
