#include <cstdio>

#include "sim/csgsim.h"

int main() {
  using namespace csgsim;
  machines::Machine machine = kinds::load("pixel-planes-4");
  machine.array = {32, 32, 72};
  const model::Tree tree = read::read_csg_text("cube(size = 2, center = true);", "cube");
  const facet::Geometry scene = facet::make_geometry(tree);
  view::Sampling sampling;
  sampling.width = sampling.height = 32;
  const view::View view = view::make_view(scene, tree, view::default_camera(scene.box, 32, 32), sampling);
  const isa::Program program = emit::compile(tree, scene, view, machine);
  observe::FrameObserver frame(program);
  engine::Observer* const observers[] = {&frame};
  const engine::RunResult result = engine::make_functional_engine(machine)->run(program, observers);
  for (const char* const name : {"user.png", "user.tif"}) {
    OutputFile file(name);
    observe::write_picture(file, frame.frame(), program);
    file.commit();
  }
  std::printf("%llu clocks\n", static_cast<unsigned long long>(result.clocks));
  return frame.frame().owner[16 * 32 + 16] == 0 && result.clocks > 0 ? 0 : 1;
}
