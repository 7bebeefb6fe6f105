#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "places.h"
#include "sim/engine/engine.h"
#include "tests/performance/program_work.h"
#include "tests/performance/schedule.h"
#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("the stretches of a replay add up to the work of the functional level") {
  for (const std::string name : {"thesis_fig_2_3", "old_example002_lines", "thesis_fig_2_3_squares"}) {
    CAPTURE(name);
    const isa::Program program = isa::load_program(std::string(CSGSIM_SOURCE_DIR) + "/traces/" + name + ".csgt");
    const machines::Machine machine = kinds::load(program.machine);
    const bench::Replay replay = bench::replay(program, machine);
    CHECK(replay.work == engine::make_functional_engine(machine)->run(program, {}).work);
    std::uint64_t instructions = 0;
    for (const bench::StretchShares& stretch : replay.stretches)
      for (const bench::TileShare& tile : stretch.tiles) instructions += tile.instructions;
    CHECK(instructions == replay.work.instructions);
    const bench::ProgramWork work = bench::work_of(program, replay);
    CHECK(work.segments == program.segments.size());
    CHECK(work.linear < instructions);
    CHECK(work.steps > instructions);
    CHECK(work.open < instructions);
    CHECK(work.longest <= instructions);
    CHECK(work.longest_steps <= work.steps);
  }
}

TEST_CASE("makespan() assigns each job to the first free thread") {
  const std::array<double, 5> jobs{3, 1, 1, 1, 4};
  CHECK(bench::makespan(jobs, 1) == 10);
  CHECK(bench::makespan(jobs, 2) == 7);
  CHECK(bench::makespan(jobs, 3) == 5);
  CHECK(bench::makespan(jobs, 100) == 4);
  CHECK(bench::makespan({}, 2) == 0);
}

TEST_CASE("threads that share tiles synchronize after each stretch of instructions") {
  const auto stretch = [](std::uint32_t segment, std::vector<double> seconds) {
    bench::StretchShares shares{segment, {}};
    for (const double each : seconds) shares.tiles.push_back({1, 0, 1, 0, each});
    return shares;
  };
  const bench::Replay replay{{}, {stretch(0, {4, 1}), stretch(0, {1, 4}), stretch(1, {2, 2})}};
  CHECK(bench::makespan_by_tiles(replay, 1) == 14);
  CHECK(bench::makespan_by_tiles(replay, 2) == 4 + 4 + 2);
  CHECK(bench::makespan_by_segments(replay, 1) == 14);
  CHECK(bench::makespan_by_segments(replay, 2) == 10);
}
