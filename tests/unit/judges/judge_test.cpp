#include <rapidcheck.h>

#include "hw/isa/facts.h"
#include "sim/judges/errors.h"
#include "sim/judges/explain.h"
#include "tests/numerics/solids.h"
#include "tests/oracle/random_model.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/judges/scenery.h"

using namespace csgsim;
using namespace csgsim::testing;
using judges::Errors;
using view::Projection;

namespace {

view::Sampling picture(std::uint32_t width, std::uint32_t height) {
  view::Sampling sampling;
  sampling.width = width;
  sampling.height = height;
  return sampling;
}

/// A picture with its judge.
struct Trial {
  Compiled compiled;
  judges::Truth truth;
  judges::Explainer explainer;
  observe::Frame frame;

  explicit Trial(Compiled from)
      : compiled(std::move(from)),
        truth(judges::exact_truth(compiled.tree, compiled.scene, compiled.view.camera, compiled.program.shape.width,
                                  compiled.program.shape.height, compiled.program.facts->depth_scale)),
        explainer(compiled.tree, compiled.scene, compiled.view.camera, compiled.program),
        frame(draw(compiled.program)) {}
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  [[nodiscard]] Errors judge() const { return judges::judge(truth, frame, compiled.program, explainer); }
  [[nodiscard]] std::uint32_t farthest() const { return (1U << compiled.program.facts->compile.z_bits) - 1; }

  /// Moves a pixel by `by` depth steps towards the middle of the range.
  void move(std::size_t at, std::uint32_t by) {
    std::uint32_t& depth = frame.depth[at];
    depth = depth < farthest() / 2 ? depth + by : depth - by;
  }

  void remove(std::size_t at) {
    frame.depth[at] = farthest();
    frame.owner[at] = observe::no_owner;
  }
};

const view::Camera oblique{{15, -22, 17}, {0, 0, 0}, Projection::orthographic};
const view::Camera near_by{{15, -22, 17}, {0, 0, 0}, Projection::perspective};

const std::string holed = subtract({box({-5, -5, -5}, {5, 5, 5}), cylinder({0, 0, -6}, 12, 3, 3, 9)});

/// A random model that is not empty.
std::string any_model() {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  return unite({random_model(seed, *rc::gen::inRange(1U, 9U)), random_model(~seed, 1)});
}

/// Pixels with the same plane of the same primitive in all eight neighbours.
std::vector<std::size_t> middles(const judges::Truth& truth) {
  std::vector<std::size_t> all;
  for (std::size_t y = 1; y + 1 < truth.height; ++y) {
    for (std::size_t x = 1; x + 1 < truth.width; ++x) {
      const std::size_t at = y * truth.width + x;
      bool middle = truth.owner[at] != judges::nothing;
      for (const std::size_t row : {at - truth.width, at, at + truth.width}) {
        for (const std::size_t near : {row - 1, row, row + 1}) {
          middle = middle && truth.owner[near] == truth.owner[at] && truth.plane[near] == truth.plane[at];
        }
      }
      if (middle) all.push_back(at);
    }
  }
  return all;
}

/// Whether exactly this pixel became wrong and unexplained.
bool caught(const Errors& errors, const Errors& before, std::size_t at, std::uint32_t width) {
  return errors.wrong() == before.wrong() + 1 && errors.unexplained == 1 && errors.first_unexplained &&
         errors.first_unexplained->column == at % width && errors.first_unexplained->row == at / width;
}

}  // namespace

TEST_CASE("a correct picture has no unexplained pixels") {
  CHECK(rc::check([] {
    view::Sampling sampling = picture(48, 36);
    sampling.z_bits = *rc::gen::element(8U, 12U, 20U);
    sampling.fraction_bits = *rc::gen::element(0U, 4U, 12U);
    const Trial trial(compile_text(any_model(), {*rc::gen::element(oblique, near_by), sampling, 80}));
    const Errors errors = trial.judge();
    RC_ASSERT(errors.covered > 0U);
    RC_ASSERT(errors.unexplained == 0U);
    RC_ASSERT(errors.explained == errors.wrong());
    RC_ASSERT_FALSE(errors.first_unexplained.has_value());
  }));
}

TEST_CASE("a corrupted pixel inside a face is found and unexplained") {
  CHECK(rc::check([] {
    Trial trial(compile_text(any_model(), {*rc::gen::element(oblique, near_by), picture(48, 36), 80}));
    const std::vector<std::size_t> places = middles(trial.truth);
    RC_PRE(!places.empty());
    const std::size_t at = *rc::gen::elementOf(places);
    const Errors before = trial.judge();
    const auto count = static_cast<std::uint32_t>(trial.compiled.tree.primitives.size());
    const int how = *rc::gen::inRange(0, 4);
    if (how == 0) trial.move(at, 100);
    if (how == 1) trial.move(at, 2);
    if (how == 2) trial.remove(at);
    if (how == 3) trial.frame.owner[at] = (trial.frame.owner[at] + *rc::gen::inRange(1U, count)) % count;
    const Errors errors = trial.judge();
    RC_ASSERT(caught(errors, before, at, 48));
    RC_ASSERT(errors.depth == before.depth + (how < 2 ? 1 : 0));
    RC_ASSERT(errors.silhouette == before.silhouette + (how == 2 ? 1 : 0));
    RC_ASSERT(errors.owner == before.owner + (how == 3 ? 1 : 0));
  }));
}

TEST_CASE("a spurious pixel on the background is found and unexplained") {
  for (const view::Camera& camera : {oblique, near_by}) {
    Trial trial(compile_text(holed, {camera, picture(48, 36), 80}));
    const Errors before = trial.judge();
    CHECK(before.covered > 300);
    trial.frame.depth[50] = trial.frame.depth[48 * 18 + 20];
    trial.frame.owner[50] = 0;
    CHECK(caught(trial.judge(), before, 50, 48));
  }
}

TEST_CASE("the judge names the first of several unexplained pixels in row order") {
  Trial trial(compile_text(holed, {oblique, picture(48, 36), 80}));
  const std::vector<std::size_t> places = middles(trial.truth);
  REQUIRE(places.size() > 100);
  for (const std::size_t i : {70U, 20U, 50U}) trial.remove(places[i]);
  const Errors errors = trial.judge();
  CHECK(errors.unexplained == 3);
  REQUIRE(errors.first_unexplained);
  CHECK(errors.first_unexplained->row * 48 + errors.first_unexplained->column == places[20]);
}

TEST_CASE("a camera shift of a twentieth of a pixel is not explained") {
  const double aside = 0.05 * 2.0 * view::half_height(oblique) / 90;
  const glm::dvec3 by = view::basis(oblique).right * aside;
  Trial trial(compile_text(holed, {oblique, picture(120, 90), 80}));
  CHECK(trial.judge().unexplained == 0);
  trial.frame = draw(
      compile_text(holed, {{oblique.eye + by, oblique.centre + by, Projection::orthographic}, picture(120, 90), 80})
          .program);
  CHECK(trial.judge().unexplained > 100);
}

TEST_CASE("wrong pixels of a coarse picture are explained") {
  view::Sampling coarse = picture(120, 90);
  coarse.z_bits = 8;
  coarse.fraction_bits = 0;
  const Errors errors = Trial(compile_text(holed, {oblique, coarse, 80})).judge();
  CHECK(errors.wrong() > 0);
  CHECK(errors.explained == errors.wrong());
}

TEST_CASE("only a pixel centre exactly on an edge-on face may fall on either side") {
  // The middle column of an odd picture is on the left face.
  Trial trial(compile_text(box({0, 0, -2.5}, {2.5, 1, 2.5}), {straight_camera(21), picture(21, 21), 80}));
  CHECK(trial.judge().wrong() == 0);
  constexpr std::size_t centre = 10 * 21 + 10;
  REQUIRE(trial.truth.owner[centre] == 0);
  trial.remove(centre);
  CHECK(trial.judge().explained == 1);
  CHECK(trial.judge().unexplained == 0);
  trial.remove(centre + 1);
  CHECK(trial.judge().explained == 1);
  CHECK(trial.judge().unexplained == 1);
}

TEST_CASE("a missing pixel away from edge-on faces is not explained") {
  constexpr std::size_t centre = 10 * 21 + 10;
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    Trial trial(
        compile_text(box({-2.5, 0, -2.5}, {2.5, 1, 2.5}), {straight_camera(21, projection), picture(21, 21), 80}));
    const Errors before = trial.judge();
    REQUIRE(trial.truth.owner[centre] == 0);
    trial.remove(centre);
    CHECK(caught(trial.judge(), before, centre, 21));
  }
}

TEST_CASE("the judge rejects the second primitive on coincident faces") {
  const std::string twice = unite({box({-3, 0, -3}, {3, 2, 3}), box({-2, 0, -2}, {2, 4, 2})});
  Trial trial(compile_text(twice, {straight_camera(20), picture(20, 20), 80}));
  const Errors before = trial.judge();
  CHECK(before.wrong() == 0);
  trial.frame.owner[10 * 20 + 10] = 1;
  CHECK(caught(trial.judge(), before, 10 * 20 + 10, 20));
}

TEST_CASE("the possible steps of a plane include the drawn one and are at most two") {
  const Trial trial(compile_text(holed, {near_by, picture(64, 48), 80}));
  std::size_t seen = 0;
  for (std::uint32_t i = 0; i < trial.truth.owner.size(); ++i) {
    if (trial.truth.owner[i] == judges::nothing || trial.frame.owner[i] != trial.truth.owner[i]) continue;
    ++seen;
    const judges::Steps steps = trial.explainer.steps(trial.truth.plane[i], judges::make_place(i % 64, i / 64, 64, 48));
    CHECK(steps.low <= trial.frame.depth[i]);
    CHECK(steps.high >= trial.frame.depth[i]);
    CHECK(steps.high - steps.low <= 1);
  }
  CHECK(seen > 500);
}
