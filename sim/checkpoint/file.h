// Saves, loads and resumes checkpoints.
// Used by sim/debug and sim/session.
#pragma once

#include <filesystem>

#include "sim/checkpoint/snapshot.h"

namespace csgsim::checkpoint {

/// Writes a checkpoint; the previous one is replaced only when the new one is complete. Throws InputError.
void save_snapshot(const std::filesystem::path& path, const Snapshot& snapshot);

/// Reads a checkpoint of a run of the Program on the machine. Throws InputError.
Snapshot load_snapshot(const std::filesystem::path& path, const isa::Program& program,
                       const machines::Machine& machine);

/// The state of a run and its observers at an instruction boundary.
Snapshot take_snapshot(RunIdentity identity, const engine::Run& run, const observe::FrameObserver& frame,
                       const observe::StatsObserver& stats);

/// Restores the run and the observers from the snapshot; the run must be one of the Program of the snapshot.
void resume(const Snapshot& snapshot, engine::Run& run, observe::FrameObserver& frame, observe::StatsObserver& stats);

}  // namespace csgsim::checkpoint
