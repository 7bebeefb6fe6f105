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

/// What is wrong with the name of a picture that has to be an EXR file, or nothing.
std::string exr_name(const std::string& name) {
  return ends_in(name, ".exr") || is_unnamed_stream(name) ? "" : "'" + name + "' has to end in .exr";
}

/// The same of an owner picture.
std::string owner_name(const std::string& name) {
  return ends_in(name, ".exr") || ends_in(name, ".png") || is_unnamed_stream(name)
             ? ""
             : "'" + name + "' has to end in .png or .exr";
}

}  // namespace

std::vector<std::string> evaluator_names() { return {"worked-out", "stepped"}; }

systemc::EvaluatorForm evaluator_form(const std::string& evaluator, const std::string& level) {
  if (evaluator == "worked-out") return systemc::EvaluatorForm::worked_out;
  if (level != "cycle") throw UsageError("--evaluator", "is for the cycle level; add --level cycle");
  return systemc::EvaluatorForm::stepped;
}

observe::LongWork long_run(const std::string& level) {
  return {"the run at the " + level + " level",
          level == "functional" ? "more --threads and a smaller --size take less"
                                : "--level functional draws the same picture and tells the same counts in far less"};
}

void RunRequest::add_outputs_to(OptionList& options) {
  options
      .option("-o,--output", picture, "The picture; the format is the name's ending (.png, .tif, .ppm, ...), PNG for -")
      .check(not_empty);
  options.option("--depth", depth, "Depth picture, .exr: distance from the eye along the view axis, model units")
      .check(exr_name);
  options
      .option("--owner", owner,
              "Which primitive is seen: .png, a colour each and a legend, .json beside it; or .exr, its index")
      .check(owner_name);
  options.option("--stats", stats, "All counts, .json").check(not_empty);
}

void RunRequest::add_to(OptionList& options) {
  add_outputs_to(options);
  options
      .option("--surface", surface,
              "What --depth and --owner tell: the nearest surface that is seen, see-through or not; or the opaque one "
              "that is seen, through others or not")
      .one_of({"nearest", "opaque"}, "surface");
  options
      .option("--level", level,
              "functional (fast), cycle (SystemC, every clock) or reference (bit-serial, slow); all give the same")
      .one_of(level_names());
  options
      .option("--evaluator", evaluator,
              "Of --level cycle, the multiplier trees of frame-buffer and pixel-square: worked-out of the "
              "coefficients, or stepped "
              "adder by adder, which takes longer")
      .one_of(evaluator_names(), "evaluator");
  options.option("--threads", threads, "Threads that the functional level works on; the picture is the same")
      .between(1U, most_threads);
  options.flag("--advice", advice,
               "Try what could be turned, each of the machine's figures and each setting by one step, and tell what "
               "it is worth");
  add_progress(options, progress);
}

void refuse_overflow(const engine::RunResult& result) {
  if (result.overflows == 0) return;
  throw InputError("the Program overflows: at " + std::to_string(result.overflows) +
                   " enabled pixels a linear expression does not fit its width; compile it again");
}

Drawn draw(const isa::Program& program, const machines::Machine& machine, const std::string& level,
           bool shows_progress) {
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  std::optional<observe::ProgressObserver> progress;
  std::vector<engine::Observer*> observers{&frame, &stats};
  observe::LongWork work = long_run(level);
  if (shows_progress || level != "functional") {
    progress.emplace(program, machine).warn(work, shows_progress);
    observers.push_back(&*progress);
  }
  const auto begin = std::chrono::steady_clock::now();
  engine::RunResult result = with_memory_for_run(
      {&program, 1}, program.shape, [&] { return make_engine(machine, level, 1)->run(program, observers); });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  refuse_overflow(result);
  Drawn drawn{std::move(frame).frame(), stats.stats(), std::move(result), wall.count()};
  if (!drawn.result.scanned_out.empty()) drawn.frame.colour = drawn.result.scanned_out;
  return drawn;
}

}  // namespace csgsim::session
