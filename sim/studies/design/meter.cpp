#include "sim/studies/design/meter.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "host/emit/options.h"
#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/facts.h"
#include "hw/machines/area.h"
#include "hw/machines/kind.h"
#include "hw/machines/regions.h"
#include "hw/process/price.h"
#include "sim/engine/engine.h"
#include "sim/functional/clocks.h"
#include "sim/judges/errors.h"
#include "sim/judges/explain.h"
#include "sim/observe/frame_hash.h"
#include "sim/observe/stats_json.h"
#include "sim/studies/measured_row.h"

namespace csgsim::studies {

namespace {

void count_program(const isa::Program& program, DesignRow& row) {
  row.strategy_used = program.facts->compile.strategy;
  row.colouring_used = program.facts->compile.colouring;
  row.primitives = program.facts->model.primitives;
  row.halfspaces = program.facts->model.halfspaces;
  row.instructions = isa::total_instructions(program);
  row.rendered = program.facts->compile.rendered;
  row.classified = program.facts->compile.classified;
  row.depth_tests = program.facts->compile.depth_tests;
  row.tree_depth = program.facts->compile.tree_depth;
  row.classification_bits = program.facts->compile.stack_bits;
  row.used_bits = observe::used_memory_bits(program);
  row.memory_map = memory_map(program);
}

machines::Resources resources_of(const FittedProgram& fitted) {
  return fitted.machine.kind->resources(fitted.machine, isa::frame_header(fitted.program));
}

void count_machine(const FittedProgram& fitted, DesignRow& row) {
  const machines::Resources resources = resources_of(fitted);
  row.processors = resources.processors;
  row.machine_memory_bits = resources.memory_bits;
  row.pixel_transistors = machines::pixel_transistors(fitted.machine, fitted.machine.array.memory_bits);
  if (row.pixel_transistors) row.machine_transistors = *row.pixel_transistors * row.processors;
}

/// Sets the machine's clock to the maximum that the process allows, less the clocks of the memory's refresh.
void give_clock(const process::Process& process, FittedProgram& fitted, DesignRow& row) {
  const std::optional<process::Clock> clock = process::clock_of(fitted.machine, process);
  if (!clock) return;
  fitted.machine.clock_hz = clock->usable_hz;
  row.clock_path = clock->path.name;
}

void put(const machines::FrameTiming& timing, const machines::Machine& machine, DesignRow& row) {
  const machines::FrameRates rates =
      machines::frame_rates(machine.clock_hz, timing.interval_clocks, timing.host_clocks);
  row.clocks = timing.clocks;
  row.interval_clocks = timing.interval_clocks;
  row.host_clocks = timing.host_clocks;
  row.simulated_seconds = static_cast<double>(timing.clocks) / static_cast<double>(machine.clock_hz);
  row.frames_per_second = rates.hardware;
  row.hosted_frames_per_second = rates.hosted;
}

void price(const process::Process& process, const FittedProgram& fitted, RunTimer& timer, DesignRow& row) {
  const machines::Machine& machine = fitted.machine;
  const machines::Resources resources = resources_of(fitted);
  const std::uint64_t pixel_clocks =
      process::pixel_clocks(fitted.program, machine, timer.outcome(fitted.program, machine).skips);
  row.machine_mm2 = process::machine_mm2(machine, resources, process);
  row.frame_joules = process::frame_joules(machine, resources, {pixel_clocks, 1 / row.frames_per_second}, process);
}

/// The point without colours and ALU, which do not affect the bits of a classification.
DesignPoint without_colours(DesignPoint point) {
  point.colour_bits = 0;
  point.alu_bits = 0;
  return point;
}

/// Memory bits per pixel that hold colours.
std::uint32_t bits_of_colours(unsigned colour_bits, const Job& job) {
  const bool is_twice = job.options.colouring == emit::Colouring::field;
  return colour_bits * (is_twice ? 2U : 1U) + machines::second_buffer(colour_bits, job.machine).width;
}

/// Maximum difference of a channel.
unsigned colour_error(const observe::Frame& exact, const observe::Frame& frame, unsigned bits) {
  int max_difference = 0;
  for (std::size_t i = 0; i < frame.colour.size(); ++i) {
    const auto of_exact = isa::unpack_colour(exact.colour[i], isa::max_colour_bits);
    const auto of_frame = isa::unpack_colour(frame.colour[i], bits);
    for (std::size_t channel = 0; channel < of_exact.size(); ++channel)
      max_difference = std::max(max_difference, std::abs(int{of_exact[channel]} - int{of_frame[channel]}));
  }
  return static_cast<unsigned>(max_difference);
}

DrawnProgram draw_exactly(FittedProgram fitted) {
  DrawnProgram drawn = draw(std::move(fitted.program), fitted.machine);
  if (drawn.has_overflow) throw std::logic_error("a linear expression does not fit its width");
  return drawn;
}

DesignRow refused_row(const DesignPoint& point, const Job& job) {
  DesignRow row;
  row.point = point;
  row.inputs = job.inputs;
  row.reason = job.reason;
  return row;
}

}  // namespace

DrawnProgram draw(isa::Program program, const machines::Machine& machine) {
  observe::FrameObserver frame(program);
  const std::array<engine::Observer*, 1> observers{&frame};
  const engine::RunResult result = engine::make_functional_engine(machine)->run(program, observers);
  return {std::move(program), std::move(frame).frame(), engine::timing_of(result), result.overflows > 0};
}

DesignRow measure_picture(const DesignPoint& point, const Job& job, bool is_drawn) {
  if (!job.reason.empty()) return refused_row(point, job);
  std::optional<isa::Program> program;
  DesignRow row = measured_row<DesignRow>(point, job.inputs, [&](DesignRow& counted) {
    program = compile(job);
    count_program(*program, counted);
  });
  if (!row.is_compiled()) return row;
  row.pixel_transistors = machines::pixel_transistors(job.machine, row.used_bits);
  if (is_drawn) {
    const DrawnProgram drawn = draw(std::move(*program), job.machine);
    put(drawn.timing, job.machine, row);
    row.picture = drawn.has_overflow ? overflow : observe::hash_of(drawn.frame);
  } else {
    put(functional::measure_timing(*program, job.machine), job.machine, row);
  }
  return row;
}

FittedProgram DesignMeter::fit_memory(const DesignPoint& point, const Job& job) {
  if (point.memory_bits) return {compile(job), job.machine};
  const Subject& subject = *job.subject;
  const view::View view = view::make_view(subject.scene, subject.tree, job.camera, job.sampling);
  const DesignPoint alike = without_colours(point);
  const unsigned colour_bits = job.options.colour_bits;
  MemoryGuess guess{0, question_.max_bits};
  {
    const std::lock_guard guard(lock_);
    if (const auto known = bits_.find(alike); known != bits_.end())
      guess.likely =
          known->second.second + bits_of_colours(colour_bits, job) - bits_of_colours(known->second.first, job);
  }
  FittedProgram fitted = compile_with_least_memory(subject.tree, subject.scene, view, job.machine, job.options, guess);
  const std::lock_guard guard(lock_);
  bits_[alike] = {colour_bits, fitted.machine.array.memory_bits};
  return fitted;
}

const judges::Truth& DesignMeter::truth_of(const Job& job, const isa::Program& program) {
  const Subject& subject = *job.subject;
  const machines::Size size = job.machine.picture;
  return truths_.get({&subject, size.width, size.height}, [&] {
    return judges::exact_truth(subject.tree, subject.scene, job.camera, size.width, size.height,
                               program.facts->depth_scale);
  });
}

DesignMeter::PixelErrors DesignMeter::pixel_errors_of(const Job& job, const DrawnProgram& drawn) {
  const judges::Explainer explainer(job.subject->tree, job.subject->scene, job.camera, drawn.program);
  const judges::Errors errors = judges::judge(truth_of(job, drawn.program), drawn.frame, drawn.program, explainer);
  return {errors.wrong(), errors.unexplained, 0};
}

/// The maximum number of colour bits is drawn and judged first; fewer colour bits leave depth and owner unchanged.
DesignMeter::ErrorsByColour DesignMeter::errors_by_colour(const DesignPoint& point, const Job& job) {
  Job one = job;
  const auto drawn_in = [&](unsigned bits) {
    one.options.colour_bits = bits;
    return draw_exactly(fit_memory(point, one));
  };
  const DrawnProgram finest = drawn_in(isa::max_colour_bits);
  ErrorsByColour errors{{isa::max_colour_bits, pixel_errors_of(job, finest)}};
  for (const unsigned bits : question_.colour_bits) {
    if (bits == isa::max_colour_bits) continue;
    const DrawnProgram drawn = drawn_in(bits);
    const bool is_alike = drawn.frame.depth == finest.frame.depth && drawn.frame.owner == finest.frame.owner;
    errors[bits] = is_alike ? errors[isa::max_colour_bits] : pixel_errors_of(job, drawn);
    errors[bits].colour_error = colour_error(finest.frame, drawn.frame, bits);
  }
  return errors;
}

void DesignMeter::judge_picture(const DesignPoint& point, const Job& job, const FittedProgram& fitted, DesignRow& row) {
  const machines::Size size = job.machine.picture;
  const PictureBitsKey seen{
      {job.subject.get(), size.width, size.height}, job.sampling.z_bits, job.sampling.fraction_bits};
  const bool has_colours = !question_.colour_bits.empty();
  const ErrorsByColour& by_colour = errors_.get(seen, [&] {
    return has_colours ? errors_by_colour(point, job) : ErrorsByColour{{0, pixel_errors_of(job, draw_exactly(fitted))}};
  });
  const PixelErrors& errors = by_colour.at(has_colours ? job.options.colour_bits : 0);
  row.wrong = errors.wrong;
  row.unexplained = errors.unexplained;
  row.colour_error = errors.colour_error;
}

DesignRow DesignMeter::measure(const DesignPoint& point, const Job& job, const process::Process* process) {
  if (!job.reason.empty()) return refused_row(point, job);
  return measured_row<DesignRow>(point, job.inputs, [&](DesignRow& row) {
    FittedProgram fitted = fit_memory(point, job);
    count_program(fitted.program, row);
    count_machine(fitted, row);
    if (process != nullptr) give_clock(*process, fitted, row);
    row.clock_hz = fitted.machine.clock_hz;
    put(timer_.time(fitted.program, fitted.machine), fitted.machine, row);
    if (process != nullptr) price(*process, fitted, timer_, row);
    judge_picture(point, job, fitted, row);
  });
}

}  // namespace csgsim::studies
