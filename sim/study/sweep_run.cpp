#include "sim/study/sweep_run.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "host/emit/compile.h"
#include "hw/isa/error.h"
#include "hw/machines/clocks.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats_json.h"
#include "sim/study/frame_hash.h"

namespace csgsim::study {

namespace {

std::string hash_of_picture(const isa::Program& program, const machines::Machine& machine) {
  sim::FrameObserver observer(program);
  const std::array<sim::Observer*, 1> observers{&observer};
  const sim::RunResult result = sim::make_functional_engine(machine)->run(program, observers);
  if (result.overflows > 0) return std::string(overflow);
  return hash_of(observer.frame());
}

isa::Program compile(const SweepJob& job) {
  const Subject& subject = *job.subject;
  const view::View view = view::make_view(subject.scene, subject.tree, job.camera, job.sampling);
  return emit::compile(subject.tree, subject.scene, view, job.machine, job.options);
}

void count(const isa::Program& program, const machines::Machine& machine, SweepRow& row) {
  row.strategy_used = program.compile.strategy;
  row.colouring_used = program.compile.colouring;
  row.primitives = program.model.primitives;
  row.halfspaces = program.model.halfspaces;
  row.clocks = machines::clocks(program, machine);
  row.simulated_seconds = static_cast<double>(row.clocks) / static_cast<double>(machine.clock_hz);
  for (const isa::Segment& segment : program.segments) row.instructions += segment.instructions.size();
  row.rendered = program.compile.rendered;
  row.classified = program.compile.classified;
  row.depth_tests = program.compile.depth_tests;
  row.tree_depth = program.compile.tree_depth;
  row.classification_bits = program.compile.stack_bits;
  row.used_bits = sim::used_memory_bits(program);
  row.memory_map = memory_map(program);
}

}  // namespace

SweepRow measure(const SweepJob& job, bool draw) {
  SweepRow row;
  row.point = job.point;
  row.model_hash = job.subject->hash;
  row.width = machines::picture_size(job.machine).width;
  row.height = machines::picture_size(job.machine).height;
  std::optional<isa::Program> program;
  try {
    program = compile(job);
  } catch (const InputError& error) {
    row.reason = error.what();
    return row;
  }
  count(*program, job.machine, row);
  if (draw) row.picture = hash_of_picture(*program, job.machine);
  return row;
}

void measure_all(std::span<const SweepJob> jobs, bool draw, unsigned threads,
                 const std::function<void(SweepRow)>& finished) {
  std::atomic<std::size_t> next = 0;
  std::mutex lock;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      try {
        SweepRow row = measure(jobs[i], draw);
        const std::lock_guard guard(lock);
        if (!failure) finished(std::move(row));
      } catch (...) {
        const std::lock_guard guard(lock);
        if (!failure) failure = std::current_exception();
        next = jobs.size();
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < std::min<std::size_t>(threads, jobs.size()); ++i) workers.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace csgsim::study
