#include "sim/session/run/checkpoint_options.h"

#include <array>
#include <memory>
#include <vector>

#include "hw/base/output_file.h"
#include "sim/checkpoint/file.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

void CheckpointOptions::add_to(OptionList& options) {
  options
      .option("--checkpoint", checkpoint,
              "Write the state of the run to this file at intervals; each checkpoint replaces the previous one when "
              "complete")
      .check(not_empty);
  options.option("--checkpoint-every", every, "Instructions between checkpoints; default: 1000");
  options.option("--resume", resume, "Continue from this checkpoint of the same Program and machine").check(not_empty);
}

void CheckpointOptions::check(std::string_view level, std::span<const std::filesystem::path> files) const {
  if (every && checkpoint.empty()) throw UsageError("--checkpoint-every", "also needs --checkpoint FILE");
  if (every == 0) throw UsageError("--checkpoint-every", "0 is not a valid interval; take at least 1");
  if (checkpoint.empty() && resume.empty()) return;
  if (level == "cycle") {
    throw UsageError(
        checkpoint.empty() ? "--resume" : "--checkpoint",
        "the cycle level cannot stop and resume; take --level functional, whose picture, clocks and counts "
        "are the same");
  }
  if (checkpoint.empty()) return;
  if (is_stream(checkpoint)) throw UsageError("--checkpoint", "a stream cannot be resumed from; name a file");
  refuse_clashes(files, std::to_array<std::filesystem::path>({checkpoint}));
  const OutputFile can_be_written(checkpoint);
}

engine::RunResult run_with_checkpoints(engine::Engine& engine, const isa::Program& program,
                                       const machines::Machine& machine, const CheckpointOptions& options,
                                       RunObservers& observers) {
  std::vector<engine::Observer*> all{&observers.frame, &observers.stats};
  if (observers.progress) all.push_back(&*observers.progress);
  if (options.checkpoint.empty() && options.resume.empty()) return engine.run(program, all);

  const std::unique_ptr<engine::Run> run = engine.begin(program);
  if (!options.resume.empty()) {
    checkpoint::resume(checkpoint::load_snapshot(options.resume, program, machine), *run, observers.frame,
                       observers.stats);
    if (observers.progress) observers.progress->begin_at(run->place());
  }
  const engine::Numbers numbers(program);
  const checkpoint::RunIdentity identity = checkpoint::identity_of(program, machine);
  while (!run->is_finished()) {
    if (options.checkpoint.empty()) {
      run->advance(engine::Run::end, all);
      break;
    }
    const std::uint64_t left = numbers.count() - numbers.of(run->place());
    const std::uint64_t stride = options.every.value_or(CheckpointOptions::default_stride);
    run->advance(stride < left ? numbers.of(run->place()) + stride : engine::Run::end, all);
    checkpoint::save_snapshot(options.checkpoint,
                              checkpoint::take_snapshot(identity, *run, observers.frame, observers.stats));
  }
  return run->result();
}

}  // namespace csgsim::session
