#include "hw/isa/facts.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/oracle/random_model.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Number of pixels at which the machine's picture differs from the rules.
std::size_t wrong_pixels(const testing::Compiled& compiled) {
  const std::vector<testing::Seen> expected = testing::draw_by_rules(compiled.tree, compiled.scene, compiled.view);
  const observe::Frame frame = testing::draw(compiled.program);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (!(testing::Seen{frame.depth[i], frame.owner[i]} == expected[i])) ++wrong;
  }
  return wrong;
}

view::Sampling small_picture(std::uint32_t width, std::uint32_t height) {
  view::Sampling sampling;
  sampling.width = width;
  sampling.height = height;
  return sampling;
}

void check_models(const view::Camera& camera, std::uint64_t first_seed,
                  const view::Sampling& sampling = small_picture(97, 71),
                  emit::Colouring colouring = emit::Options{}.colouring) {
  testing::Setup how{camera, sampling, 160};
  how.options.colouring = colouring;
  std::size_t covered = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + 60; ++seed) {
    const std::string model = testing::random_model(seed, 1 + static_cast<unsigned>(seed % 14));
    const testing::Compiled compiled = testing::compile_text(model, how);
    CAPTURE(seed);
    CHECK(wrong_pixels(compiled) == 0);
    covered += compiled.program.facts->compile.rendered;
  }
  CHECK(covered > 50);
}

}  // namespace

TEST_CASE("random models seen from the side match the rule-based oracle orthographically") {
  check_models({{30, -45, 35}, {0, 0, 0}, view::Projection::orthographic}, 1);
}
TEST_CASE("random models seen from the side match the rule-based oracle in perspective") {
  check_models({{30, -45, 35}, {0, 0, 0}, view::Projection::perspective}, 101);
}
TEST_CASE("random models with faces edge-on match the rule-based oracle orthographically") {
  check_models({{0, -60, 0}, {0, 0, 0}, view::Projection::orthographic}, 201);
}
TEST_CASE("random models seen along an axis match the rule-based oracle in perspective") {
  check_models({{0, -60, 0}, {0, 0, 0}, view::Projection::perspective}, 301);
}
TEST_CASE("random models seen straight from above match the rule-based oracle") {
  check_models({{0, 0, 60}, {0, 0, 0}, view::Projection::orthographic}, 401);
}
TEST_CASE("random models around the eye match the rule-based oracle") {
  check_models({{0.25, -1, 0.5}, {0, 3, 0}, view::Projection::perspective}, 501);
}
TEST_CASE("random models larger than the picture match the rule-based oracle") {
  check_models({{9, -8, 7}, {0, 0, 0}, view::Projection::orthographic}, 601);
}
TEST_CASE("random low-accuracy models match the oracle with any pruning and colouring") {
  struct Accuracy {
    unsigned z_bits;
    unsigned fraction_bits;
    std::uint32_t width;
  };
  for (const Accuracy& one : {Accuracy{4, 0, 97}, Accuracy{8, 0, 97}, Accuracy{12, 2, 250}, Accuracy{12, 6, 400},
                              Accuracy{20, 0, 200}, Accuracy{6, 20, 60}}) {
    view::Sampling sampling = small_picture(one.width, one.width / 2);
    sampling.z_bits = one.z_bits;
    sampling.fraction_bits = one.fraction_bits;
    CAPTURE(one.z_bits);
    CAPTURE(one.fraction_bits);
    for (const emit::Colouring colouring : {emit::Colouring::rebroadcast, emit::Colouring::field}) {
      CAPTURE(emit::name_of(colouring));
      check_models({{30, -45, 35}, {0, 0, 0}, view::Projection::orthographic}, 701, sampling, colouring);
      check_models({{11, -16, 12}, {0, 0, 0}, view::Projection::perspective}, 801, sampling, colouring);
    }
  }
}
TEST_CASE("the objects of the thesis match the rule-based oracle") {
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      CHECK(wrong_pixels(
                testing::compile_file(testing::model_path(one.name), {one.camera, small_picture(160, 120), 72})) == 0);
    }
  }
}
