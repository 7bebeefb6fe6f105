#include "sim/study/sweep_run.h"

#include <array>
#include <optional>
#include <utility>

#include "host/emit/compile.h"
#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/machines/area.h"
#include "sim/engine/engine.h"
#include "sim/functional/clocks.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats_json.h"
#include "sim/study/frame_hash.h"
#include "sim/study/parallel.h"

namespace csgsim::study {

namespace {

/// Of one picture, or `overflow`.
std::string picture_of(const sim::FrameObserver& observer, const sim::RunResult& result) {
  if (result.overflows > 0) return std::string(overflow);
  return hash_of(observer.frame());
}

void draw(const isa::Program& program, const machines::Machine& machine, SweepRow& row) {
  sim::FrameObserver observer(program);
  const std::array<sim::Observer*, 1> observers{&observer};
  const sim::RunResult result = sim::make_functional_engine(machine)->run(program, observers);
  row.clocks = result.clocks;
  row.picture = picture_of(observer, result);
}

isa::Program compile(const SweepJob& job) {
  const Subject& subject = *job.subject;
  const view::View view = view::make_view(subject.scene, subject.tree, job.camera, job.sampling);
  return emit::compile(subject.tree, subject.scene, view, job.machine, job.options,
                       [&](const isa::Program& program) { return sim::clocks_of_run(program, job.machine); });
}

void count(const isa::Program& program, const machines::Machine& machine, SweepRow& row) {
  row.strategy_used = program.facts.compile.strategy;
  row.colouring_used = program.facts.compile.colouring;
  row.primitives = program.facts.model.primitives;
  row.halfspaces = program.facts.model.halfspaces;
  for (const isa::Segment& segment : program.segments) row.instructions += segment.instructions.size();
  row.rendered = program.facts.compile.rendered;
  row.classified = program.facts.compile.classified;
  row.depth_tests = program.facts.compile.depth_tests;
  row.tree_depth = program.facts.compile.tree_depth;
  row.classification_bits = program.facts.compile.stack_bits;
  row.used_bits = sim::used_memory_bits(program);
  row.pixel_transistors = machines::pixel_transistors(machine, row.used_bits);
  row.memory_map = memory_map(program);
}

}  // namespace

SweepRow measure(const SweepJob& job, bool is_drawn) {
  SweepRow row;
  row.point = job.point;
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
    row.clocks = sim::clocks_of_run(*program, job.machine);
  }
  row.simulated_seconds = static_cast<double>(row.clocks) / static_cast<double>(job.machine.clock_hz);
  return row;
}

void measure_all(std::span<const SweepJob> jobs, bool is_drawn, unsigned threads,
                 const std::function<void(SweepRow)>& finished) {
  measure_each(
      jobs.size(), threads, [&](std::size_t i) { return measure(jobs[i], is_drawn); }, finished);
}

}  // namespace csgsim::study
