#include "sim/studies/explore/measure.h"

#include <algorithm>
#include <array>

#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/isa/program.h"
#include "hw/machines/area.h"
#include "hw/machines/kind.h"
#include "hw/process/price.h"
#include "sim/engine/engine.h"
#include "sim/judges/errors.h"
#include "sim/judges/explain.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats_json.h"
#include "sim/studies/measured_row.h"

namespace csgsim::studies {

namespace {

/// Memory bits a pixel that a design may take where nobody says how many it has.
constexpr std::uint32_t most_fitted_bits = 512;

Fitted fitted(const ExplorePoint& point, const Job& job) {
  if (point.memory_bits) return {compile(job), job.machine};
  const Subject& subject = *job.subject;
  const view::View view = view::make_view(subject.scene, subject.tree, job.camera, job.sampling);
  return compile_fitting(subject.tree, subject.scene, view, job.machine, job.options, {0, most_fitted_bits});
}

machines::Resources resources_of(const Fitted& fitted) {
  return fitted.machine.kind->resources(fitted.machine, isa::frame_header(fitted.program));
}

void count(const Fitted& fitted, ExploreRow& row) {
  const isa::Program& program = fitted.program;
  const machines::Machine& machine = fitted.machine;
  row.halfspaces = program.facts->model.halfspaces;
  row.instructions = isa::instructions_in(program);
  row.used_bits = observe::used_memory_bits(program);
  const machines::Resources resources = resources_of(fitted);
  row.processors = resources.processors;
  row.machine_memory_bits = resources.memory_bits;
  row.pixel_transistors = machines::pixel_transistors(machine, machine.array.memory_bits);
  if (row.pixel_transistors) row.machine_transistors = *row.pixel_transistors * row.processors;
}

/// The machine with the clock that the process leaves it.
void give_clock(const process::Process& process, Fitted& fitted, ExploreRow& row) {
  const std::optional<process::Clock> clock = process::clock_of(fitted.machine, process);
  if (!clock) return;
  fitted.machine.clock_hz = clock->hz;
  row.clock_path = clock->path.name;
}

void time(const Fitted& fitted, RunTimer& timer, ExploreRow& row) {
  const machines::FrameTiming timing = timer.time(fitted.program, fitted.machine);
  row.clock_hz = fitted.machine.clock_hz;
  row.clocks = timing.clocks;
  row.interval_clocks = timing.interval_clocks;
  row.frames_per_second = static_cast<double>(row.clock_hz) / static_cast<double>(timing.interval_clocks);
}

void price(const process::Process& process, const Fitted& fitted, RunTimer& timer, ExploreRow& row) {
  const machines::Machine& machine = fitted.machine;
  const machines::Resources resources = resources_of(fitted);
  const std::uint64_t pixel_clocks =
      process::pixel_clocks(fitted.program, machine, timer.told(fitted.program, machine).skips);
  row.machine_mm2 = process::machine_mm2(machine, resources, process);
  row.frame_joules = process::frame_joules(machine, resources, {pixel_clocks, 1 / row.frames_per_second}, process);
}

observe::Frame frame_of(const Fitted& fitted) {
  observe::FrameObserver observer(fitted.program);
  const std::array<engine::Observer*, 1> observers{&observer};
  const engine::RunResult result = engine::make_functional_engine(fitted.machine)->run(fitted.program, observers);
  if (result.overflows > 0) throw InputError("a linear expression does not fit its width; this is a fault of csgsim");
  return std::move(observer).frame();
}

}  // namespace

const judges::Truth& ExploreMeter::truth_of(const Job& job, const isa::Program& program) {
  const Subject& subject = *job.subject;
  const machines::Size size = job.machine.picture;
  Exact* exact = nullptr;
  {
    const std::lock_guard guard(lock_);
    exact = &truths_[{&subject, size.width, size.height}];
  }
  std::call_once(exact->once, [&] {
    exact->truth = judges::exact_truth(subject.tree, subject.scene, job.camera, size.width, size.height,
                                       program.facts->depth_scale);
  });
  return exact->truth;
}

void ExploreMeter::judge(const Job& job, const Fitted& fitted, ExploreRow& row) {
  const machines::Size size = job.machine.picture;
  const Seen seen{job.subject.get(), size.width, size.height};
  Verdict* verdict = nullptr;
  {
    const std::lock_guard guard(lock_);
    verdict = &verdicts_[{seen, job.sampling.z_bits, job.sampling.fraction_bits}];
  }
  std::call_once(verdict->once, [&] {
    const Subject& subject = *job.subject;
    const judges::Truth& truth = truth_of(job, fitted.program);
    const judges::Explainer explainer(subject.tree, subject.scene, job.camera, fitted.program);
    const judges::Errors errors = judges::judge(truth, frame_of(fitted), fitted.program, explainer);
    verdict->wrong = errors.wrong();
    verdict->unexplained = errors.unexplained;
  });
  row.wrong = verdict->wrong;
  row.unexplained = verdict->unexplained;
}

ExploreRow ExploreMeter::measure(const ExplorePoint& point, const Job& job,
                                 const std::optional<process::Process>& process) {
  if (!job.reason.empty()) {
    ExploreRow refused;
    refused.point = point;
    refused.inputs = job.inputs;
    refused.reason = job.reason;
    return refused;
  }
  return measured_row<ExploreRow>(point, job.inputs, [&](ExploreRow& row) {
    Fitted fitted = studies::fitted(point, job);
    count(fitted, row);
    if (process) give_clock(*process, fitted, row);
    time(fitted, timer_, row);
    if (process) price(*process, fitted, timer_, row);
    judge(job, fitted, row);
  });
}

}  // namespace csgsim::studies
