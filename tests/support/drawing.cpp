#include "tests/support/drawing.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "host/read/read.h"
#include "hw/kinds/load.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/kind.h"
#include "hw/pixel_square/kind.h"
#include "hw/scan_line/kind.h"
#include "places.h"
#include "sim/engine/engine.h"

namespace csgsim::testing {

machines::Machine machine_of(const isa::ArrayShape& array) {
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.array = array;
  machine.clock_hz = 10'000'000;
  machines::kind_figures<pixel_planes::Figures>(machine).or_fan_in =
      64;  // the value of pixel-planes-4, on which the latency of queries depends
  machine.evaluator_degree = 2;
  return machine;
}

namespace {

/// Exact curved surfaces as requested by the setup, except for primitives that do not fit the machine.
facet::Faceting faceting_of(const model::Tree& tree, const Setup& setup) {
  facet::Faceting faceting;
  faceting.exact_curves = setup.exact_curves;
  if (!setup.exact_curves) return faceting;
  const facet::Geometry scene = facet::make_geometry(tree, faceting);
  const view::View view = view::make_view(scene, tree, setup.camera, setup.sampling);
  for (const facet::Convex& solid : scene.solids) {
    faceting.faceted.push_back(
        std::any_of(solid.quadrics.begin(), solid.quadrics.end(), [&](const facet::QuadricSide& side) {
          return view.quadrics[side.quadric].kind == view::ScreenQuadricKind::unfit;
        }));
  }
  return faceting;
}

machines::Machine machine_for(const Setup& setup) {
  machines::Machine machine = machine_of({setup.sampling.width, setup.sampling.height, setup.memory_bits});
  if (setup.kind != machine.kind) {
    const machines::Machine whole = machine;
    machine = machines::blank_machine(*setup.kind);
    machine.array = whole.array;
    machine.clock_hz = whole.clock_hz;
  }
  machine.picture = {setup.sampling.width, setup.sampling.height};
  if (setup.kind == &scan_line::kind) machine.array.height = 1;
  if (setup.kind == &pixel_square::kind) {
    machine.array.width = setup.square.width;
    machine.array.height = setup.square.height;
  }
  if (setup.kind == &pixel_planes::kind) {
    machines::kind_figures<pixel_planes::Figures>(machine).has_global_or = setup.has_global_or;
  }
  if (!setup.machine.empty()) {
    machine = kinds::load(setup.machine);
    machines::set_picture_size(machine, {setup.sampling.width, setup.sampling.height});
  }
  if (setup.exact_curves) {
    machine.evaluator_degree = 2;
    machine.array.memory_bits = setup.memory_bits;
  }
  return machine;
}

Compiled compile_tree(model::Tree tree, const Setup& setup) {
  facet::Geometry scene = facet::make_geometry(tree, faceting_of(tree, setup));
  view::View view = view::make_view(scene, tree, setup.camera, setup.sampling);
  Compiled compiled{std::move(tree), std::move(scene), std::move(view), {}};
  compiled.program = compile_again(compiled, setup);
  return compiled;
}

}  // namespace

Compiled compile_text(const std::string& csg, const Setup& setup) {
  return compile_tree(read::read_csg_text(csg, "test"), setup);
}

isa::Program compile_again(const Compiled& compiled, const Setup& setup) {
  isa::Program program = emit::compile(compiled.tree, compiled.scene, compiled.view, machine_for(setup), setup.options);
  isa::validate(program);
  return program;
}

Compiled compile_file(const std::string& path, const Setup& setup) {
  return compile_tree(read::read_csg_file(path), setup);
}

Compiled compile_default_view(const std::string& path, Setup setup, view::Projection projection) {
  model::Tree tree = read::read_csg_file(path);
  setup.camera = view::default_camera(facet::make_geometry(tree).box, setup.sampling.width, setup.sampling.height);
  setup.camera.projection = projection;
  return compile_tree(std::move(tree), setup);
}

observe::Frame draw(const isa::Program& program, unsigned threads) {
  machines::Machine machine = machine_of(program.shape);
  machine.evaluator_degree = 2;
  return draw_on(std::move(machine), program, threads);
}

observe::Frame draw_on(machines::Machine machine, const isa::Program& program, unsigned threads) {
  machines::adopt_shape(machine, program);
  observe::FrameObserver frame(program);
  const std::array<engine::Observer*, 1> observers{&frame};
  const engine::RunResult result = engine::make_functional_engine(machine, threads)->run(program, observers);
  if (result.overflows != 0) throw std::runtime_error("a linear expression overflows its width");
  return frame.frame();
}

std::string model_path(const std::string& name) {
  return std::string(CSGSIM_SOURCE_DIR) + "/tests/models/" + name + ".csg";
}

std::vector<ThesisObject> thesis_objects(view::Projection projection) {
  return {{"thesis_fig_2_3", {{42, -38, 41}, {10, 5.5, 2}, projection}},
          {"carburettor", {{220, -255, 135}, {2, 0, 5}, projection}},
          {"terrain_vehicle", {{560, -590, 420}, {-5, 0, 68}, projection}},
          {"rietveld_house", {{3430, -2900, 1950}, {590, 230, 220}, projection}}};
}

view::Camera camera(const glm::dvec3& eye, const glm::dvec3& centre, view::Projection projection) {
  return {eye, centre, projection};
}

}  // namespace csgsim::testing
