#include "tests/unit/division/agreement.h"

#include <rapidcheck.h>

#include "tests/oracle/random_model.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

view::Camera any_camera() {
  const auto coordinate = [](int low, int high) { return 0.25 * *rc::gen::inRange(4 * low, 4 * high); };
  view::Camera camera;
  camera.centre = {coordinate(-2, 2), coordinate(-2, 2), coordinate(-2, 2)};
  // Near cameras are inside the model.
  const int reach = *rc::gen::element(3, 20, 60);
  camera.eye = {coordinate(-reach, reach), coordinate(-reach, reach), coordinate(-reach, reach)};
  if (camera.eye == camera.centre) camera.eye.z += 10.0;
  camera.projection = *rc::gen::element(view::Projection::orthographic, view::Projection::perspective);
  return camera;
}

view::Sampling any_sampling(const view::Camera& camera) {
  view::Sampling sampling;
  sampling.width = *rc::gen::inRange(1U, 90U);
  sampling.height = *rc::gen::inRange(1U, 60U);
  sampling.z_bits = *rc::gen::element(4U, 6U, 12U, 20U, 30U);
  sampling.fraction_bits = *rc::gen::element(0U, 1U, 4U, 12U, 20U);
  sampling.edge_on_fraction = *rc::gen::element(1.0 / 256, 1.0 / 16, 1.0);
  if (camera.projection == view::Projection::perspective && *rc::gen::arbitrary<bool>()) sampling.near = 1.0;
  return sampling;
}

testing::DivisionCase any_case() {
  const view::Camera camera = any_camera();
  const view::Sampling sampling = any_sampling(camera);
  const auto square =
      *rc::gen::element(std::pair{7U, 3U}, std::pair{8U, 8U}, std::pair{16U, 16U}, std::pair{128U, 128U});
  testing::DivisionCase how;
  how.setup = testing::squares_of(camera, sampling, {square.first, square.second},
                                  *rc::gen::element(emit::Colouring::rebroadcast, emit::Colouring::field));
  how.group_side = *rc::gen::inRange(1U, 6U);
  how.list_entries = *rc::gen::element<std::uint64_t>(0, 12, 40, 1'000'000);
  return how;
}

}  // namespace

TEST_CASE("the divider emits the host's instructions and counts at one level or two") {
  constexpr unsigned models = 40;  // number per camera and sampling
  std::uint64_t refused = 0;
  std::uint64_t drawn = 0;
  division::Counts all;
  CHECK(rc::check([&] {
    const testing::DivisionCase how = any_case();
    const auto first = *rc::gen::arbitrary<std::uint64_t>();
    for (unsigned i = 0; i < models; ++i) {
      try {
        const testing::ForDivider made =
            testing::compile_for_divider(testing::random_model(first + i, 1 + i % 16), how.setup);
        ++drawn;
        const std::string what = testing::difference(made, how, all);
        if (!what.empty()) RC_FAIL(what);
      } catch (const InputError& error) {
        RC_LOG() << error.what() << "\n";
        ++refused;
      }
    }
  }));
  if (!testing::draws_usual_cases()) return;
  // Both reject a near plane behind the model and faces that fit no width. Every other model causes some work.
  CHECK(refused * 4 <= drawn);
  for (const std::uint64_t count : {all.boxes, all.halfspaces, all.cells, all.nodes, all.instructions})
    CHECK(count > drawn);
}
