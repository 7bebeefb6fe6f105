#include "sim/studies/sweep/measure.h"

#include <array>
#include <optional>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/program.h"
#include "hw/machines/area.h"
#include "sim/engine/engine.h"
#include "sim/functional/clocks.h"
#include "sim/observe/frame.h"
#include "sim/observe/frame_hash.h"
#include "sim/observe/stats_json.h"

namespace csgsim::studies {

namespace {

/// Of one picture, or `overflow`.
std::string hash_or_overflow(const observe::FrameObserver& observer, const engine::RunResult& result) {
  if (result.overflows > 0) return std::string(overflow);
  return hash_of(observer.frame());
}

void draw(const isa::Program& program, const machines::Machine& machine, SweepRow& row) {
  observe::FrameObserver observer(program);
  const std::array<engine::Observer*, 1> observers{&observer};
  const engine::RunResult result = engine::make_functional_engine(machine)->run(program, observers);
  row.clocks = result.clocks;
  row.picture = hash_or_overflow(observer, result);
}

void count(const isa::Program& program, const machines::Machine& machine, SweepRow& row) {
  row.strategy_used = program.facts->compile.strategy;
  row.colouring_used = program.facts->compile.colouring;
  row.primitives = program.facts->model.primitives;
  row.halfspaces = program.facts->model.halfspaces;
  row.instructions = isa::instructions_in(program);
  row.rendered = program.facts->compile.rendered;
  row.classified = program.facts->compile.classified;
  row.depth_tests = program.facts->compile.depth_tests;
  row.tree_depth = program.facts->compile.tree_depth;
  row.classification_bits = program.facts->compile.stack_bits;
  row.used_bits = observe::used_memory_bits(program);
  row.pixel_transistors = machines::pixel_transistors(machine, row.used_bits);
  row.memory_map = memory_map(program);
}

}  // namespace

SweepRow measure(const SweepPoint& point, const Job& job, bool is_drawn) {
  SweepRow row;
  row.point = point;
  row.inputs = job.inputs;
  row.width = job.machine.picture.width;
  row.height = job.machine.picture.height;
  row.reason = job.reason;
  if (!row.compiled()) return row;
  std::optional<isa::Program> program;
  try {
    program = compile(job);
  } catch (const InputError& error) {
    row.reason = escaped(error.what());
    return row;
  }
  count(*program, job.machine, row);
  if (is_drawn) {
    draw(*program, job.machine, row);
  } else {
    row.clocks = functional::clocks_of_run(*program, job.machine);
  }
  row.simulated_seconds = static_cast<double>(row.clocks) / static_cast<double>(job.machine.clock_hz);
  return row;
}

}  // namespace csgsim::studies
