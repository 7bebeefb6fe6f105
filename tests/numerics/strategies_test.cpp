#include <rapidcheck.h>

#include "tests/numerics/variants.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/oracle/random_model.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

testing::Setup setup(const view::Camera& camera, std::uint32_t width, std::uint32_t height) {
  testing::Setup made;
  made.camera = camera;
  made.sampling.width = width;
  made.sampling.height = height;
  made.memory_bits = 4096;
  return made;
}

void check_same_pictures(const std::string& text, testing::Setup how) {
  const testing::Compiled first = testing::compile_text(text, how);
  const observe::Frame expected = testing::draw(first.program);
  const std::vector<testing::Seen> rules = testing::draw_by_rules(first.tree, first.scene, first.view);
  for (std::size_t i = 0; i < rules.size(); ++i) {
    RC_ASSERT((testing::Seen{expected.depth[i], expected.owner[i]} == rules[i]));
  }
  for (const emit::Options& options : testing::all_options()) {
    how.options = options;
    const observe::Frame frame = testing::draw(testing::compile_text(text, how).program);
    RC_ASSERT(frame.depth == expected.depth);
    RC_ASSERT(frame.owner == expected.owner);
    RC_ASSERT(frame.colour == expected.colour);
  }
  for (const testing::Setup& parts : testing::setups_in_parts(how)) {
    const observe::Frame frame = testing::draw(testing::compile_text(text, parts).program);
    RC_ASSERT(frame.depth == expected.depth);
    RC_ASSERT(frame.owner == expected.owner);
    RC_ASSERT(frame.colour == expected.colour);
  }
}

void check_random_models(const testing::Setup& how) {
  CHECK(rc::check([&] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto size = static_cast<unsigned>(*rc::gen::inRange(1, 13));
    check_same_pictures(testing::random_model(seed, size), how);
  }));
}

void check_random_models(const view::Camera& camera) { check_random_models(setup(camera, 61, 43)); }

}  // namespace

TEST_CASE("all options and machines draw random models orthographically alike") {
  check_random_models({{30, -45, 35}, {0, 0, 0}, view::Projection::orthographic});
}
TEST_CASE("all options and machines draw random models in perspective alike") {
  check_random_models({{30, -45, 35}, {0, 0, 0}, view::Projection::perspective});
}
TEST_CASE("all options and machines draw random models seen along an axis alike") {
  check_random_models({{0, -60, 0}, {0, 0, 0}, view::Projection::orthographic});
}
TEST_CASE("all options and machines draw random models around the eye alike") {
  check_random_models({{0.25, -1, 0.5}, {0, 3, 0}, view::Projection::perspective});
}
TEST_CASE("all options and machines draw the same picture with few bits of depth") {
  testing::Setup how = setup({{10, -10, 10}, {0, 0, 0}, view::Projection::orthographic}, 48, 64);
  how.sampling.z_bits = 6;
  how.sampling.fraction_bits = 2;
  check_random_models(how);
  // Rounding moves the front of a solid before the near plane, where its colour once depended on whether a facet was
  // pruned.
  CHECK_NOTHROW(check_same_pictures(
      "multmatrix([[1,0.5,0,-3],[0,1,1,2],[0,0,1,0],[0,0,0,1]]){cylinder($fn=8,h=1,r1=3,r2=1);}"
      "multmatrix([[1,0,0,2],[0,1,0,0],[0,0,1,-3],[0,0,0,1]]){intersection(){difference(){"
      "multmatrix([[0,0,1,2],[0,1,0,-1],[-1,0,0,0],[0,0,0,1]]){sphere($fn=4,r=4);}sphere($fn=6,r=1);}"
      "sphere($fn=4,r=4);}}",
      how));
}
TEST_CASE("all options and machines draw the same picture of the thesis's objects") {
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      testing::Setup how = setup(one.camera, testing::cases(160U, 56U), testing::cases(120U, 42U));
      const observe::Frame expected = testing::draw(testing::compile_file(testing::model_path(one.name), how).program);
      for (const emit::Options& options : testing::all_options()) {
        CAPTURE(emit::name_of(options.strategy));
        CAPTURE(options.stack_bits);
        how.options = options;
        const observe::Frame frame = testing::draw(testing::compile_file(testing::model_path(one.name), how).program);
        CHECK(frame.depth == expected.depth);
        CHECK(frame.owner == expected.owner);
        CHECK(frame.colour == expected.colour);
      }
      for (const testing::Setup& parts : testing::setups_in_parts(how)) {
        CAPTURE(parts.kind->name);
        CAPTURE(parts.square.width);
        const observe::Frame frame = testing::draw(testing::compile_file(testing::model_path(one.name), parts).program);
        CHECK(frame.depth == expected.depth);
        CHECK(frame.owner == expected.owner);
        CHECK(frame.colour == expected.colour);
      }
    }
  }
}
