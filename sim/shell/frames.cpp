#include "sim/shell/frames.h"

#include <fmt/format.h>

#include <deque>
#include <filesystem>
#include <memory>
#include <numbers>
#include <vector>

#include "hw/base/output_file.h"
#include "sim/cycle/sequence.h"
#include "sim/observe/frame.h"
#include "sim/observe/pictures.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/near_faces_warning.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/memory.h"

namespace csgsim::shell {

namespace {

namespace fs = std::filesystem;

void refuse_other_outputs(const RunRequest& run) {
  for (const auto& [option, name] : {std::pair("--depth", &run.depth),
                                     {"--owner", &run.owner},
                                     {"--stats", &run.stats},
                                     {"--report", &run.report.file}}) {
    if (!name->empty()) throw UsageError(option, "is for one frame; leave out --frames");
  }
}

/// One path per frame; empty if no picture is requested.
std::vector<fs::path> picture_paths(const fs::path& picture, std::uint32_t frames) {
  std::vector<fs::path> paths;
  for (std::uint32_t i = 0; i < frames && !picture.empty(); ++i) {
    paths.push_back(picture.parent_path() /
                    fmt::format("{}_{:03}{}", picture.stem().native(), i, picture.extension().native()));
  }
  return paths;
}

std::vector<isa::Program> compile_frames(const ModelRequest& model, const Turntable& turntable,
                                         const machines::Machine& machine) {
  CompiledModel first = compile_model(model, machine);
  warn_of_near_faces(first, model);
  std::vector<isa::Program> programs;
  programs.push_back(std::move(first.program));
  for (std::uint32_t i = 1; i < turntable.frames; ++i) {
    const double radians = i * turntable.degrees * std::numbers::pi / 180.0;
    programs.push_back(compile_for_camera(view::turned(first.camera, radians), first, model, machine));
  }
  return programs;
}

std::vector<engine::RunResult> run_frames(const machines::Machine& machine, const RunRequest& run,
                                          const std::vector<isa::Program>& programs,
                                          const std::vector<engine::Observer*>& observers) {
  const systemc::EvaluatorForm form = evaluator_form(run.evaluator, run.level);
  if (run.level == "cycle") return cycle::run_sequence(machine, programs, observers, form);
  const auto engine = make_engine(machine, run.level, run.threads);
  std::vector<engine::RunResult> results;
  for (std::size_t i = 0; i < programs.size(); ++i) results.push_back(engine->run(programs[i], {&observers[i], 1}));
  return results;
}

void print_frames(const std::vector<engine::RunResult>& results, const machines::Machine& machine) {
  std::uint64_t clocks = 0;
  fmt::print("{:<8}{:>14}{:>14}{:>14}\n", "frame", "drawn after", "shown after", "next after");
  for (std::size_t i = 0; i < results.size(); ++i) {
    const engine::RunResult& result = results[i];
    clocks += result.interval_clocks;
    fmt::print("{:<8}{:>14}{:>14}{:>14}\n", i, grouped(result.clocks), grouped(result.shown_clocks),
               grouped(result.interval_clocks));
  }
  const double seconds = static_cast<double>(clocks) / static_cast<double>(machine.clock_hz);
  fmt::print("{} in {} clocks = {:.4g} frames a second\n", counted(results.size(), "frame"), grouped(clocks),
             seconds == 0 ? 0.0 : static_cast<double>(results.size()) / seconds);
}

void draw(const RunRequest& run, const std::vector<isa::Program>& programs, const machines::Machine& machine,
          std::deque<OutputFile>& files) {
  std::vector<std::unique_ptr<observe::FrameObserver>> frames;
  std::vector<engine::Observer*> observers;
  observers.reserve(programs.size());
  for (const isa::Program& program : programs)
    observers.push_back(frames.emplace_back(std::make_unique<observe::FrameObserver>(program)).get());
  const std::vector<engine::RunResult> results = run_frames(machine, run, programs, observers);
  for (const engine::RunResult& result : results) refuse_overflow(result);
  std::vector<OutputFile*> written;
  for (std::size_t i = 0; i < files.size(); ++i) {
    observe::Frame picture = frames[i]->frame();
    if (!results[i].scanned_out.empty()) picture.colour = results[i].scanned_out;
    observe::write_picture(files[i], picture, programs[i]);
    written.push_back(&files[i]);
  }
  commit_all(written);
  print_frames(results, machine);
}

}  // namespace

void draw_frames(const ModelRequest& model, const RunRequest& run, const Turntable& turntable,
                 const machines::Machine& machine) {
  refuse_other_outputs(run);
  if (!run.picture.empty() && is_stream(run.picture))
    throw UsageError("--output", "several pictures have several names; name a file, or leave out --frames");
  const std::vector<fs::path> paths = picture_paths(run.picture, turntable.frames);
  refuse_clashes(model.inputs(), paths);
  refuse_other_format("--output", run.picture);
  std::deque<OutputFile> files;
  for (const fs::path& path : paths) files.emplace_back(path);
  const std::vector<isa::Program> programs = compile_frames(model, turntable, machine);
  announce_memory(machine, programs.front().shape, run.level);
  with_memory_for_run(programs, machine.array, [&] { draw(run, programs, machine, files); });
}

}  // namespace csgsim::shell
