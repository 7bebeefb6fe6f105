// bench_render_speed [MODEL.csg]: how fast the levels draw a model at 512 x 512 (the terrain vehicle if none is
// named), and the most memory the process took.

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>

#include "hw/kinds/load.h"
#include "hw/machines/machine.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"
#include "tests/support/drawing.h"

namespace {

using namespace csgsim;

/// Wall seconds of the fastest of some runs with the observers that render has.
double fastest(engine::Engine& engine, const isa::Program& program, int runs, std::uint64_t& clocks) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < runs; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    observe::FrameObserver frame(program);
    observe::StatsObserver stats(program);
    const std::array<engine::Observer*, 2> observers{&frame, &stats};
    clocks = engine.run(program, observers).clocks;
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best;
}

void report(engine::Engine& engine, const isa::Program& program, const machines::Machine& machine, int runs) {
  std::uint64_t clocks = 0;
  const double wall = fastest(engine, program, runs, clocks);
  const double simulated = static_cast<double>(clocks) / static_cast<double>(machine.clock_hz);
  fmt::print(
      "{:<12}{:>10} clocks  {:>8.2f} ms simulated  {:>8.2f} ms wall  {:>12.0f} clocks/s  {:>7.3f} simulated s / wall "
      "s\n",
      engine.level(), clocks, simulated * 1e3, wall * 1e3, static_cast<double>(clocks) / wall, simulated / wall);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string model = argc > 1 ? argv[1] : testing::model_path("terrain_vehicle");
    testing::Setup setup{{{560, -590, 420}, {-5, 0, 68}, view::Projection::perspective}, {}, 72};
    machines::Machine machine = kinds::load("pixel-planes-4");
    const auto begin = std::chrono::steady_clock::now();
    const isa::Program program =
        argc > 1 ? testing::compile_default_view(model, setup, view::Projection::perspective).program
                 : testing::compile_file(model, setup).program;
    const std::chrono::duration<double> compile = std::chrono::steady_clock::now() - begin;
    fmt::print("{}: {} instructions, compiled in {:.1f} ms\n", model, program.segments.at(0).instructions.size(),
               compile.count() * 1e3);
    report(*engine::make_functional_engine(machine), program, machine, 20);
    report(*engine::make_cycle_engine(machine), program, machine, 3);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print("most memory {:.0f} MB\n", static_cast<double>(usage.ru_maxrss) / 1024.0);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
