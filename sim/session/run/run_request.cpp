#include "sim/session/run/run_request.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/progress.h"
#include "sim/observe/stats.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/memory.h"

namespace csgsim::session {

namespace {

/// The problem of a picture name that must be an EXR file, or an empty string.
std::string exr_name_problem(const std::string& name) {
  return has_extension(name, ".exr") || is_unnamed_stream(name) ? "" : "'" + name + "' must end in .exr";
}

/// The problem of the name of an owner picture, or an empty string.
std::string owner_name_problem(const std::string& name) {
  return has_extension(name, ".exr") || has_extension(name, ".png") || is_unnamed_stream(name)
             ? ""
             : "'" + name + "' must end in .png or .exr";
}

}  // namespace

std::vector<std::string> evaluator_names() { return {"worked-out", "stepped"}; }

systemc::EvaluatorForm evaluator_form(const std::string& evaluator, const std::string& level) {
  if (evaluator == "worked-out") return systemc::EvaluatorForm::computed;
  if (level != "cycle") throw UsageError("--evaluator", "is for the cycle level; add --level cycle");
  return systemc::EvaluatorForm::stepped;
}

observe::LongWork long_run_warning(const std::string& level) {
  return {"the run at the " + level + " level",
          level == "functional" ? "more --threads or a smaller --size take less time"
                                : "--level functional gives the same picture and counts much faster"};
}

void RunRequest::add_outputs_to(OptionList& options) {
  options
      .option("-o,--output", picture,
              "The picture; the name's ending selects the format (.png, .tif, .ppm, ...), PNG for -")
      .check(not_empty);
  options.option("--depth", depth, "Depth picture, .exr: distance from the eye along the view axis, in model units")
      .check(exr_name_problem);
  options
      .option(
          "--owner", owner,
          "Picture of the visible primitives: .png with a colour each and a .json legend, or .exr with their indices")
      .check(owner_name_problem);
  options.option("--stats", stats, "All counts, .json").check(not_empty);
}

void RunRequest::add_to(OptionList& options) {
  add_outputs_to(options);
  options
      .option("--surface", surface,
              "Surface in --depth and --owner: the nearest visible one, transparent or not, or the nearest opaque one, "
              "even behind transparent ones")
      .one_of({"nearest", "opaque"}, "surface");
  options
      .option("--level", level,
              "functional (fast), cycle (SystemC, every clock) or reference (pixel by pixel, slow); all give the same "
              "results")
      .one_of(level_names());
  options
      .option("--evaluator", evaluator,
              "Multiplier trees of frame-buffer and pixel-square machines with --level cycle: worked-out from the "
              "coefficients, or stepped adder by adder, which takes longer")
      .one_of(evaluator_names(), "evaluator");
  options.option("--threads", threads, "Threads of the functional level; the picture does not depend on their number")
      .between(1U, max_threads);
  options.flag("--advice", advice,
               "Try each machine parameter and each setting changed by one step, and report what the change is worth");
  add_progress_option(options, progress);
}

void refuse_overflow(const engine::RunResult& result) {
  if (result.overflows == 0) return;
  throw InputError("the Program overflows: at " + std::to_string(result.overflows) +
                   " enabled pixels a linear expression does not fit its width; compile the model again");
}

DrawnRun draw(const isa::Program& program, const machines::Machine& machine, const std::string& level,
              bool shows_progress) {
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  std::optional<observe::ProgressObserver> progress;
  std::vector<engine::Observer*> observers{&frame, &stats};
  observe::LongWork work = long_run_warning(level);
  if (shows_progress || level != "functional") {
    progress.emplace(program, machine).warn(work, shows_progress);
    observers.push_back(&*progress);
  }
  const auto begin = std::chrono::steady_clock::now();
  engine::RunResult result = with_memory_for_run(
      {&program, 1}, program.shape, [&] { return make_engine(machine, level, 1)->run(program, observers); });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  refuse_overflow(result);
  DrawnRun drawn{std::move(frame).frame(), stats.stats(), std::move(result), wall.count()};
  if (!drawn.result.scanned_out.empty()) drawn.frame.colour = drawn.result.scanned_out;
  return drawn;
}

}  // namespace csgsim::session
