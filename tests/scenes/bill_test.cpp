#include "hw/isa/facts.h"
#include "hw/kinds/load.h"
#include "sim/engine/engine.h"
#include "sim/observe/stats.h"
#include "tests/scenes/scene_file.h"
#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("the clocks of solids and effects of every scene add up to the frame's clocks") {
  const std::vector<testing::SceneFile> files = testing::scene_files();
  const auto step = testing::cases<std::size_t>(1, 3);
  for (std::size_t at = 0; at < files.size(); at += step) {
    const testing::SceneFile& file = files[at];
    CAPTURE(file.name);
    const testing::DrawnScene drawn = testing::compile_scene(file, 48, 32);
    const isa::Program& program = drawn.compiled.program;
    machines::Machine machine = kinds::load("pixel-planes-4");
    machines::adopt_shape(machine, program);
    observe::StatsObserver stats(program);
    const std::array<engine::Observer*, 1> observers{&stats};
    const engine::RunResult result = engine::make_functional_engine(machine)->run(program, observers);
    observe::Cost sum;
    for (const observe::Cost& one : stats.stats().by_effect) sum += one;
    CHECK(sum == stats.stats().total);
    CHECK(stats.stats().by_effect.size() == program.facts->compile.effects.size() + 1);
    std::uint64_t besides = result.latency_clocks;
    for (const machines::PartAccount& part : result.account.parts) {
      if (part.part != "controller") continue;
      for (const machines::ActivityClocks& one : part.clocks)
        if (one.activity == "clearing" || one.activity == "starved" || one.activity == "jumping") besides += one.clocks;
    }
    CHECK(sum.clocks + besides == result.clocks);
  }
}
