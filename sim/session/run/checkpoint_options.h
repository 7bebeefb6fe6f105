// Options of checkpoints, and runs that write or resume them.
// Used by finished_run.h and run_file.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/progress.h"
#include "sim/observe/stats.h"
#include "sim/session/options/option_list.h"

namespace csgsim::session {

/// The observers of a run.
struct RunObservers {
  observe::FrameObserver frame;
  observe::StatsObserver stats;
  std::optional<observe::ProgressObserver> progress;
};

/// Options of a run that can be interrupted and resumed.
struct CheckpointOptions {
  static constexpr std::uint64_t default_stride = 1000;

  std::string checkpoint;
  std::optional<std::uint64_t> every;
  std::string resume;

  void add_to(OptionList& options);

  /// Rejects contradictory options, and a checkpoint that cannot be written or is one of these files. Throws
  /// UsageError, InputError.
  void check(std::string_view level, std::span<const std::filesystem::path> files) const;
};

/// Runs the Program from its beginning or from the checkpoint to resume, and writes checkpoints. Throws InputError.
engine::RunResult run_with_checkpoints(engine::Engine& engine, const isa::Program& program,
                                       const machines::Machine& machine, const CheckpointOptions& options,
                                       RunObservers& observers);

}  // namespace csgsim::session
