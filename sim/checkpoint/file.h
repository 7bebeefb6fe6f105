#pragma once

#include <filesystem>

#include "sim/checkpoint/snapshot.h"

namespace csgsim::checkpoint {

/// Writes a whole checkpoint in the place of the one before, or leaves that. Throws InputError.
void save_snapshot(const std::filesystem::path& path, const Snapshot& snapshot);

/// Reads a checkpoint of a run of the Program on the machine. Throws InputError.
Snapshot load_snapshot(const std::filesystem::path& path, const isa::Program& program,
                       const machines::Machine& machine);

/// What a run and its observers hold at an instruction boundary.
Snapshot take_snapshot(RunIdentity identity, const engine::Run& run, const observe::FrameObserver& frame,
                       const observe::StatsObserver& stats);

/// Has the run go on from the snapshot, which is one of its Program, and the observers from what they had gathered.
void resume(const Snapshot& snapshot, engine::Run& run, observe::FrameObserver& frame, observe::StatsObserver& stats);

}  // namespace csgsim::checkpoint
