#include "tests/lockstep/divided_program.h"

#include <rapidcheck.h>

#include <optional>

#include "host/emit/compile.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "hw/base/error.h"
#include "tests/oracle/random_model.h"

namespace csgsim::test {

namespace {

constexpr std::uint64_t most_refused = 100;

view::Camera any_camera() {
  const auto coordinate = [](int low, int high) { return 0.25 * *rc::gen::inRange(4 * low, 4 * high); };
  view::Camera camera;
  camera.centre = {coordinate(-2, 2), coordinate(-2, 2), coordinate(-2, 2)};
  const int reach = *rc::gen::element(3, 20, 60);  // near cameras are inside the model
  camera.eye = {coordinate(-reach, reach), coordinate(-reach, reach), coordinate(-reach, reach)};
  if (camera.eye == camera.centre) camera.eye.z += 10.0;
  camera.projection = *rc::gen::element(view::Projection::orthographic, view::Projection::perspective);
  return camera;
}

}  // namespace

isa::Program any_divided_program(const machines::Machine& machine) {
  const view::Camera camera = any_camera();
  view::Sampling sampling;
  sampling.width = machine.picture.width;
  sampling.height = machine.picture.height;
  sampling.z_bits = *rc::gen::element(4U, 6U, 12U);
  sampling.fraction_bits = *rc::gen::element(0U, 4U, 12U);
  emit::Options options;
  options.colouring = *rc::gen::element(emit::Colouring::rebroadcast, emit::Colouring::field);
  options.colour_bits = *rc::gen::element(3U, 9U, 24U);
  auto seed = *rc::gen::arbitrary<std::uint64_t>();
  for (const std::uint64_t last = seed + most_refused; seed != last; ++seed) {
    try {
      const model::Tree tree =
          read::read_csg_text(testing::random_model(seed, 1 + static_cast<unsigned>(seed % 12)), "random");
      const facet::Geometry scene = facet::make_geometry(tree);
      const view::View view = view::make_view(scene, tree, camera, sampling);
      return emit::compile(tree, scene, view, machine, options);
    } catch (const InputError& error) {
      RC_LOG() << error.what() << "\n";
    }
  }
  RC_FAIL("the host rejects every random model");
  return {};
}

}  // namespace csgsim::test
