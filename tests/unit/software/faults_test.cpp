#include "sim/software/display/faults.h"

#include <glm/vec3.hpp>

#include "host/read/read.h"
#include "host/view/projection.h"
#include "hw/isa/depth_scale.h"
#include "sim/software/display/real_depths.h"
#include "sim/software/rays/caster.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using testing::Scene;

TEST_CASE("a wrong pixel of list priority is attributed to coincidence or wrong order") {
  const std::vector<software::Event> exact{{10, 0}, {20, 2}, {20, 4}, {40, 1}, {40, 3}, {41, 5}, {60, 7}};
  const std::vector<double> level{10, 20, 20, 40, 40, 40, 60};
  const auto fault = [&](std::vector<software::Event> drawn) { return software::fault_of({exact, level, 1}, drawn); };
  CHECK(fault({{0, 0}, {0, 2}}) == software::Fault::coincident);
  CHECK(fault({{0, 0}, {0, 4}}) == software::Fault::coincident);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 3}}) == software::Fault::three_way);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 1}, {0, 5}}) == software::Fault::three_way);
  CHECK(fault({{0, 2}}) == software::Fault::order);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 7}}) == software::Fault::order);
  CHECK(fault({{0, 0}, {0, 9}}) == software::Fault::order);
  CHECK(fault({{0, 0}}) == software::Fault::order);
}
TEST_CASE("a wrong pixel with surfaces in real depth order is attributed to depth bits") {
  const std::vector<software::Event> exact{{10, 0}, {20, 2}, {20, 4}, {40, 1}, {43, 3}};
  const auto fault = [&](const std::vector<double>& depths, std::vector<software::Event> drawn) {
    return software::fault_of({exact, depths, 1}, drawn);
  };
  // One depth in integers and two in real numbers.
  CHECK(fault({10, 20.2, 20.7, 40, 43}, {{0, 0}, {0, 2}}) == software::Fault::depth_bits);
  CHECK(fault({10, 20.2, 20.7, 40, 43}, {{0, 0}, {0, 4}}) == software::Fault::depth_bits);
  // Integers are three steps apart; real depths have the reverse order.
  CHECK(fault({10, 20.2, 20.7, 42.5, 42.4}, {{0, 0}, {0, 2}, {0, 4}, {0, 3}}) == software::Fault::depth_bits);
  // Less than a step apart, more than a step, and equal.
  CHECK(fault({10, 20.2, 20.7, 41.5, 42.4}, {{0, 0}, {0, 2}, {0, 4}, {0, 3}}) == software::Fault::depth_bits);
  CHECK(fault({10, 20.2, 20.7, 41.3, 42.4}, {{0, 0}, {0, 2}, {0, 4}, {0, 3}}) == software::Fault::order);
  CHECK(fault({10, 20.2, 20.7, 42, 42}, {{0, 0}, {0, 2}, {0, 4}, {0, 3}}) == software::Fault::coincident);
  const std::vector<double> level{10, 20, 20, 40, 43};
  CHECK(software::fault_of({exact, level, 1, true}, std::vector<software::Event>{{0, 0}}) ==
        software::Fault::depth_bits);
  CHECK(software::fault_of({exact, std::vector<double>{10, 20.2, 20.7, 41.3, 42.4}, 1.2},
                           std::vector<software::Event>{{0, 0}, {0, 2}, {0, 4}, {0, 3}}) ==
        software::Fault::depth_bits);
  // A surface drawn before one that is nearer, by real depths too, is an order fault, whatever else applies.
  CHECK(fault({10, 20.2, 20.7, 42.5, 42.4}, {{0, 2}, {0, 0}, {0, 4}, {0, 3}}) == software::Fault::order);
}

TEST_CASE("surfaces coincide within 2^-10 of a step and an order fault exceeds rounding") {
  const std::vector<software::Event> exact{{10, 0}, {20, 2}, {20, 4}, {30, 1}};
  const auto tied = [&](double apart) {
    return software::fault_of({exact, std::vector<double>{10, 20, 20 + apart, 30}, 1},
                              std::vector<software::Event>{{0, 0}, {0, 2}});
  };
  CHECK(tied(0x1p-10) == software::Fault::coincident);
  CHECK(tied(0x1p-10 + 0x1p-40) == software::Fault::depth_bits);
  CHECK(tied(-0x1p-10) == software::Fault::coincident);
  CHECK(tied(-0x1p-10 - 0x1p-40) == software::Fault::depth_bits);
  const auto overtaken = [&](double by) {
    return software::fault_of({exact, std::vector<double>{10, 20, 25, 25 + by}, 1.5},
                              std::vector<software::Event>{{0, 0}, {0, 2}, {0, 1}});
  };
  CHECK(overtaken(1.5) == software::Fault::depth_bits);
  CHECK(overtaken(1.5 + 0x1p-40) == software::Fault::order);
}
TEST_CASE("a pixel that is wrong for several reasons counts under the most severe one") {
  // Three surfaces are near 20, two of them coincide; two coincide at 40; two at 60 coincide in integers only.
  const std::vector<software::Event> exact{{20, 0}, {20, 2}, {21, 4}, {40, 1}, {40, 3}, {60, 6}, {60, 8}};
  const std::vector<double> depths{20, 20, 20.5, 40, 40, 60, 60.5};
  const auto fault = [&](std::vector<software::Event> drawn) { return software::fault_of({exact, depths, 1}, drawn); };
  // The second came before the first, the fifth before the fourth, the seventh before the sixth.
  CHECK(fault({{0, 2}}) == software::Fault::three_way);
  CHECK(fault({{0, 2}, {0, 0}, {0, 4}, {0, 3}}) == software::Fault::three_way);
  CHECK(fault({{0, 2}, {0, 0}, {0, 4}, {0, 3}, {0, 1}, {0, 8}}) == software::Fault::three_way);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 3}, {0, 1}, {0, 8}}) == software::Fault::coincident);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 3}, {0, 1}, {0, 6}}) == software::Fault::coincident);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 1}, {0, 3}, {0, 8}}) == software::Fault::depth_bits);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 1}, {0, 3}, {0, 6}}) == software::Fault::depth_bits);
}
TEST_CASE("faults of list priority are counted by cause") {
  software::Faults faults;
  CHECK(faults.depth_bits + faults.coincident + faults.three_way + faults.order == 0);
  CHECK(faults.all() == 0);
  for (int i = 0; i < 1; ++i) faults.add(software::Fault::depth_bits);
  for (int i = 0; i < 2; ++i) faults.add(software::Fault::coincident);
  for (int i = 0; i < 4; ++i) faults.add(software::Fault::three_way);
  for (int i = 0; i < 8; ++i) faults.add(software::Fault::order);
  CHECK(faults.depth_bits == 1);
  CHECK(faults.coincident == 2);
  CHECK(faults.three_way == 4);
  CHECK(faults.order == 8);
  CHECK(faults.all() == 15);
}
TEST_CASE("the rounding limit is a step and 1.5 fraction units per pixel from the middle") {
  for (const unsigned fraction_bits : {0U, 2U, 12U}) {
    view::Sampling sampling;
    sampling.width = 6;
    sampling.height = 3;
    sampling.fraction_bits = fraction_bits;
    const Scene scene = testing::make_scene(read::read_csg_text("cube(size=[8,8,8],center=true);", "block"),
                                            {{0, -60, 0}, {0, 0, 0}, view::Projection::orthographic}, sampling);
    const software::RealDepths real(scene.geometry, scene.view);
    const double unit = 1.5 / (1U << fraction_bits);
    // The middle is at column 2.5 and row 1.
    CHECK(real.rounding(2, 1) == 1 + unit * 1.5);
    CHECK(real.rounding(3, 1) == 1 + unit * 1.5);
    CHECK(real.rounding(0, 0) == 1 + unit * 4.5);
    CHECK(real.rounding(5, 2) == 1 + unit * 4.5);
    CHECK(real.rounding(1, 2) == 1 + unit * 3.5);
  }
}
TEST_CASE("a primitive around the ray's start is entered at 0 and left at its nearest plane") {
  // The camera is in a block of 80, a quarter of the way from its middle to the face that it looks at.
  view::Sampling sampling;
  sampling.width = 5;
  sampling.height = 3;
  sampling.near = 1;
  const Scene scene = testing::make_scene(read::read_csg_text("cube(size=[80,80,80],center=true);", "block"),
                                          {{0, 10, 0}, {0, 11, 0}, view::Projection::perspective}, sampling);
  const software::RealDepths real(scene.geometry, scene.view);
  CHECK(real.depth_of(0, 2, 1) == 0);
  CHECK(real.depth_of(0, 0, 2) == 0);
  CHECK(real.depth_of(1, 2, 1) == doctest::Approx(isa::depth_of(scene.view.depth, 20, 30)).epsilon(1e-9));
}

namespace {

/// Depth steps at which the ray of a pixel meets a primitive, from its planes in model space.
double depth_by_rays(const Scene& scene, std::uint32_t crossing, std::uint32_t column, std::uint32_t row) {
  const view::EyeSpace eye = view::eye_space(scene.view.camera, scene.view.sampling);
  const glm::dvec3 centre = scene.geometry.planes.centre();
  const glm::dvec3 near = eye.to_model(eye.from_picture({column, row, eye.perspective ? 1.0 : 0.0}));
  const glm::dvec3 from = (eye.perspective ? eye.eye : near) - centre;
  const glm::dvec3 along = eye.perspective ? near - eye.eye : eye.axes.forward;
  double enters = 0;
  double leaves = 1e300;
  for (const facet::Halfspace halfspace : scene.geometry.solids[crossing / 2].halfspaces) {
    if (scene.view.planes[halfspace.plane].kind == view::PlaneKind::edge) continue;
    const facet::Plane& plane = scene.geometry.planes.planes()[halfspace.plane];
    const double sign = halfspace.positive ? 1 : -1;
    const double slope = sign * glm::dot(plane.normal, along);
    const double t = -sign * plane.height(from) / slope;
    if (eye.perspective && t <= 0) return -1;
    const double depth = isa::depth_of(scene.view.depth, scene.view.sampling.z_bits, t);
    if (slope < 0) enters = std::max(enters, depth);
    if (slope > 0) leaves = std::min(leaves, depth);
  }
  return crossing % 2 == 0 ? enters : leaves;
}

}  // namespace

TEST_CASE("the real depths of a primitive are where the ray meets its planes") {
  std::uint64_t held = 0;
  std::uint64_t scenes = 0;
  for (std::uint64_t seed = 1; scenes < 40; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    ++scenes;
    CAPTURE(seed);
    const software::RealDepths real(scene->geometry, scene->view);
    const software::RayCaster rays(scene->tree, scene->geometry, scene->view);
    const double step = std::ldexp(1e-9, static_cast<int>(scene->view.sampling.z_bits));
    software::RayBand band;
    for (std::uint32_t row = 0; row < rays.height(); row += software::band_rows) {
      rays.cast(row, band);
      for (std::uint32_t ray = 0; ray < band.rays(); ray += 7) {
        const std::uint32_t column = ray % rays.width();
        const std::uint32_t at = row + ray / rays.width();
        for (const software::Event& event : band.events_of(ray)) {
          const double expected = depth_by_rays(*scene, event.crossing, column, at);
          if (expected < 0) continue;
          ++held;
          CHECK(real.depth_of(event.crossing, column, at) == doctest::Approx(expected).epsilon(1e-9).scale(1 + step));
        }
      }
    }
  }
  CHECK(held > 1000);
}
