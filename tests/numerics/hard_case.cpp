#include "tests/numerics/hard_case.h"

#include "host/read/read.h"
#include "hw/isa/facts.h"
#include "hw/pixel_planes/kind.h"
#include "sim/engine/engine.h"
#include "sim/judges/errors.h"
#include "sim/judges/explain.h"
#include "tests/numerics/solids.h"
#include "tests/support/software_ways.h"
#include "tests/support/test.h"

namespace csgsim::testing {

namespace {

constexpr glm::dvec3 oblique{0.61, -0.74, 0.52};
constexpr glm::dvec3 along_axis{0, -1, 0};

constexpr std::uint32_t small_width = 24;
constexpr std::uint32_t small_height = 20;

/// A single machine for all Programs: SystemC allows one elaboration per process.
machines::Machine small_machine() {
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.name = "small";
  machine.array = {small_width, small_height, 512};
  machine.clock_hz = 10'000'000;
  return machine;
}

observe::Frame run(engine::Engine& engine, const isa::Program& program) {
  observe::FrameObserver frame(program);
  const std::array<engine::Observer*, 1> observers{&frame};
  const engine::RunResult result = engine.run(program, observers);
  REQUIRE(result.overflows == 0);
  return frame.frame();
}

bool same(const observe::Frame& a, const observe::Frame& b) {
  return a.depth == b.depth && a.owner == b.owner && a.colour == b.colour;
}

void compare_engines(const std::string& csg, const view::Camera& camera, Look how) {
  how.sampling.width = small_width;
  how.sampling.height = small_height;
  const Compiled compiled = compile_text(csg, {camera, how.sampling, how.memory_bits});
  machines::Machine machine = small_machine();
  const auto cycle = engine::make_cycle_engine(machine);
  machine.array = compiled.program.shape;
  const auto functional = engine::make_functional_engine(machine);
  const auto reference = engine::make_reference_engine(machine);
  const observe::Frame frame = run(*functional, compiled.program);
  CHECK(same(frame, run(*reference, compiled.program)));
  CHECK(same(frame, run(*cycle, compiled.program)));
}

judges::Errors errors_of(const Compiled& compiled, const observe::Frame& frame) {
  const judges::Explainer explainer(compiled.tree, compiled.scene, compiled.view.camera, compiled.program);
  return judges::judge(truth_of(compiled), frame, compiled.program, explainer);
}

/// Moves the camera by an offset unrelated to the pixel size, so that nothing symmetric lies on pixel centres.
view::Camera aside(const view::Camera& camera) {
  const glm::dvec3 by = glm::length(camera.eye - camera.centre) * glm::dvec3(0.00137, 0.00291, -0.00173);
  return {camera.eye + by, camera.centre + by, camera.projection, camera.up};
}

Verdict look_from(const std::string& csg, const std::vector<glm::dvec3>& directions, const Look& how) {
  Verdict sum;
  for (const std::string_view turn : {turns::none, turns::right_angle, turns::arbitrary, turns::hair}) {
    const std::string turned = with_transform(std::string(turn), csg);
    for (const glm::dvec3& direction : directions) {
      for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        CAPTURE(turned);
        const bool aligned = direction == along_axis;
        const view::Camera camera = whole(turned, direction, projection);
        Verdict verdict = look(turned, aligned ? camera : aside(camera), how);
        if (aligned && (turn == turns::hair || turn == turns::arbitrary)) std::swap(verdict.wrong, verdict.by_a_hair);
        sum += verdict;
      }
    }
  }
  return sum;
}

}  // namespace

Verdict& Verdict::operator+=(const Verdict& other) {
  pictures += other.pictures;
  covered += other.covered;
  wrong += other.wrong;
  by_a_hair += other.by_a_hair;
  return *this;
}

judges::Truth truth_of(const Compiled& compiled) {
  return judges::exact_truth(compiled.tree, compiled.scene, compiled.view.camera, compiled.program.shape.width,
                             compiled.program.shape.height, compiled.program.facts->depth_scale);
}

observe::Frame picture_of(const std::string& csg, const view::Camera& camera, const Look& how) {
  return draw(compile_text(csg, {camera, how.sampling, how.memory_bits}).program);
}

Verdict look(const std::string& csg, const view::Camera& camera, const Look& how) {
  CAPTURE(camera.eye.x);
  CAPTURE(camera.eye.y);
  CAPTURE(camera.eye.z);
  CAPTURE((camera.projection == Projection::perspective));
  const Compiled compiled = compile_text(csg, {camera, how.sampling, how.memory_bits});
  const observe::Frame frame = draw(compiled.program);
  const judges::Errors errors = errors_of(compiled, frame);
  CHECK_MESSAGE(errors.unexplained == 0, judges::to_text(errors));
  CHECK(describe_software_mismatch(csg, compiled.tree, compiled.scene, compiled.view, frame) == "");
  if (how.engines) compare_engines(csg, camera, how);
  return {1, errors.covered, errors.wrong(), 0};
}

Verdict look_around(const std::string& csg, const Look& how) { return look_from(csg, {oblique, along_axis}, how); }

Verdict look_obliquely(const std::string& csg, const Look& how) { return look_from(csg, {oblique}, how); }

view::Camera whole(const std::string& csg, const glm::dvec3& direction, Projection projection) {
  const facet::Geometry scene = facet::make_geometry(read::read_csg_text(csg, "test"));
  const view::Camera camera = view::view_all({direction, glm::dvec3(0), projection}, scene.box, 1, 1);
  // An empty model is seen from an arbitrary place.
  return scene.box.empty() ? view::Camera{30.0 * direction, glm::dvec3(0), projection} : camera;
}

bool same_depths(const observe::Frame& a, const observe::Frame& b) { return a.depth == b.depth; }

std::uint64_t covered_pixels(const observe::Frame& frame, unsigned z_bits) {
  const auto farthest = static_cast<std::uint32_t>((1ULL << z_bits) - 1);
  return static_cast<std::uint64_t>(
      std::count_if(frame.depth.begin(), frame.depth.end(), [&](std::uint32_t z) { return z != farthest; }));
}

}  // namespace csgsim::testing
