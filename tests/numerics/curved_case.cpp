#include "tests/numerics/curved_case.h"

#include "host/read/read.h"
#include "hw/isa/facts.h"
#include "sim/engine/engine.h"
#include "sim/judges/errors.h"
#include "sim/judges/explain.h"
#include "sim/judges/truth.h"
#include "tests/numerics/variants.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/support/software_ways.h"
#include "tests/support/test.h"

namespace csgsim::testing {

namespace {

constexpr std::uint32_t memory_bits = 1600;
constexpr std::uint32_t engines_width = 24;
constexpr std::uint32_t engines_height = 20;

constexpr glm::dvec3 oblique{0.61, -0.74, 0.52};
constexpr glm::dvec3 along_axis{0, -1, 0};

bool same(const observe::Frame& a, const observe::Frame& b) {
  return a.depth == b.depth && a.owner == b.owner && a.colour == b.colour;
}

/// Number of pixels at which the two pictures differ.
std::uint64_t different(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < b.size(); ++i) count += a[i] != b[i] ? 1U : 0U;
  return count;
}

/// A single machine for all Programs: SystemC allows one elaboration per process.
machines::Machine engines_machine() {
  machines::Machine machine = machine_of({engines_width, engines_height, memory_bits});
  machine.name = "curved";
  machine.evaluator_degree = 2;
  return machine;
}

observe::Frame run(engine::Engine& engine, const isa::Program& program) {
  observe::FrameObserver frame(program);
  const std::array<engine::Observer*, 1> observers{&frame};
  REQUIRE(engine.run(program, observers).overflows == 0);
  return frame.frame();
}

void compare_engines(const std::string& csg, const view::Camera& camera, CurvedLook how) {
  how.width = engines_width;
  how.height = engines_height;
  const isa::Program program = compile_text(csg, curved_setup(camera, how)).program;
  machines::Machine machine = engines_machine();
  const auto cycle = engine::make_cycle_engine(machine);
  machine.array = program.shape;
  const observe::Frame frame = run(*engine::make_functional_engine(machine), program);
  CHECK(same(frame, run(*engine::make_reference_engine(machine), program)));
  CHECK(same(frame, run(*cycle, program)));
}

judges::Errors errors_of(const Compiled& compiled, const observe::Frame& frame) {
  const judges::Explainer explainer(compiled.tree, compiled.scene, compiled.view.camera, compiled.program);
  const judges::Truth truth =
      judges::exact_truth(compiled.tree, compiled.scene, compiled.view.camera, compiled.program.shape.width,
                          compiled.program.shape.height, compiled.program.facts->depth_scale);
  return judges::judge(truth, frame, compiled.program, explainer);
}

std::uint64_t pixels_against_rules(const Compiled& compiled, const observe::Frame& frame) {
  const std::vector<Seen> rules = draw_by_rules(compiled.tree, compiled.scene, compiled.view);
  std::uint64_t different = 0;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (!(Seen{frame.depth[i], frame.owner[i]} == rules[i])) ++different;
  }
  return different;
}

/// Checks that other machines and options draw the same picture.
void check_variants(const Compiled& compiled, const Setup& how, const CurvedLook& look,
                    const observe::Frame& expected) {
  const auto check = [&](const Setup& other) {
    CAPTURE(emit::name_of(other.options.strategy));
    CAPTURE(other.options.stack_bits);
    CAPTURE(emit::name_of(other.options.colouring));
    CAPTURE(other.kind->name);
    CAPTURE(other.machine);
    const observe::Frame frame = draw(compile_again(compiled, other));
    CHECK(different(frame.depth, expected.depth) == 0);
    CHECK(different(frame.owner, expected.owner) == 0);
    CHECK(different(frame.colour, expected.colour) == 0);
  };
  std::vector<Setup> all = setups_in_parts(how);
  for (const Setup& machine : setups_on_quadratic_machines(how)) all.push_back(machine);
  for (const emit::Options& options : all_options()) {
    all.push_back(how);
    all.back().options = options;
  }
  for (std::size_t i = look.share; i < all.size(); i += look.shares) check(all[i]);
}

bool is_faceted(const Compiled& compiled) {
  facet::Faceting exact;
  exact.exact_curves = true;
  const facet::Geometry wanted = facet::make_geometry(compiled.tree, exact);
  for (std::size_t i = 0; i < wanted.solids.size(); ++i) {
    if (wanted.solids[i].quadrics.size() != compiled.scene.solids[i].quadrics.size()) return true;
  }
  return false;
}

}  // namespace

CurvedVerdict& CurvedVerdict::operator+=(const CurvedVerdict& other) {
  pictures += other.pictures;
  covered += other.covered;
  wrong += other.wrong;
  unexplained += other.unexplained;
  against_rules += other.against_rules;
  quadrics += other.quadrics;
  edges += other.edges;
  inside += other.inside;
  return *this;
}

Setup curved_setup(const view::Camera& camera, const CurvedLook& how) {
  Setup setup;
  setup.camera = camera;
  setup.sampling.width = how.width;
  setup.sampling.height = how.height;
  setup.sampling.z_bits = how.z_bits;
  setup.sampling.fraction_bits = how.fraction_bits;
  setup.sampling.near = how.near;
  setup.memory_bits = memory_bits;
  setup.exact_curves = true;
  return setup;
}

CurvedVerdict judge_picture(const Compiled& compiled, const observe::Frame& frame) {
  const judges::Errors errors = errors_of(compiled, frame);
  CurvedVerdict verdict;
  verdict.pictures = 1;
  verdict.covered = errors.covered;
  verdict.wrong = errors.wrong();
  verdict.unexplained = errors.unexplained;
  verdict.against_rules = pixels_against_rules(compiled, frame);
  for (const view::ScreenQuadric& quadric : compiled.view.quadrics) {
    ++verdict.quadrics;
    if (quadric.kind == view::ScreenQuadricKind::edge) ++verdict.edges;
    if (quadric.kind == view::ScreenQuadricKind::roots && quadric.eye_inside) ++verdict.inside;
  }
  return verdict;
}

CurvedVerdict look_curved(const std::string& csg, const view::Camera& camera, const CurvedLook& how) {
  CAPTURE(csg);
  CAPTURE(camera.eye.x);
  CAPTURE(camera.eye.y);
  CAPTURE(camera.eye.z);
  CAPTURE((camera.projection == Projection::perspective));
  const Setup setup = curved_setup(camera, how);
  const Compiled compiled = compile_text(csg, setup);
  CHECK((how.may_be_faceted || !is_faceted(compiled)));
  const observe::Frame frame = draw(compiled.program);
  const CurvedVerdict verdict = judge_picture(compiled, frame);
  CHECK_MESSAGE(verdict.unexplained == 0, judges::to_text(errors_of(compiled, frame)));
  CHECK(verdict.against_rules == 0);
  check_variants(compiled, setup, how, frame);
  CHECK(describe_software_mismatch(csg, compiled.tree, compiled.scene, compiled.view, frame) == "");
  if (how.engines) compare_engines(csg, camera, how);
  return verdict;
}

CurvedVerdict look_both_ways(const std::string& csg, const glm::dvec3& eye, const glm::dvec3& centre,
                             const CurvedLook& how) {
  CurvedVerdict sum;
  CurvedLook part = how;
  part.shares *= 2;
  part.share *= 2;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    if (projection == Projection::orthographic) part.near.reset();
    sum += look_curved(csg, {eye, centre, projection}, part);
    ++part.share;
  }
  return sum;
}

CurvedVerdict look_at_all(const std::string& csg, const CurvedLook& how) {
  facet::Faceting exact;
  exact.exact_curves = true;
  const facet::Box box = facet::make_geometry(read::read_csg_text(csg, "test"), exact).box;
  CurvedVerdict sum;
  CurvedLook part = how;
  part.shares *= 4;
  part.share *= 4;
  for (const glm::dvec3& direction : {oblique, along_axis}) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
      // An empty model is seen from an arbitrary place.
      const view::Camera camera = box.empty() ? view::Camera{30.0 * direction, glm::dvec3(0), projection}
                                              : view::view_all({direction, glm::dvec3(0), projection}, box, 1, 1);
      sum += look_curved(csg, camera, part);
      ++part.share;
    }
  }
  return sum;
}

observe::Frame curved_picture(const std::string& csg, const view::Camera& camera, const CurvedLook& how) {
  return draw(compile_text(csg, curved_setup(camera, how)).program);
}

}  // namespace csgsim::testing
