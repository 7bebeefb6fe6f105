// A run's state at an instruction boundary, and its file format.
// Used by sim/checkpoint and sim/debug.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/engine/run.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"

namespace csgsim::checkpoint {

/// Hashes that identify Program and machine of a run; no protection against forgery.
struct RunIdentity {
  std::uint64_t program = 0;  ///< hash of the Program's binary form
  std::uint64_t machine = 0;  ///< hash of the machine's hardware; names and sources do not matter

  constexpr bool operator==(const RunIdentity&) const = default;
};

/// Hashes the Program and the machine of a run.
RunIdentity identity_of(const isa::Program& program, const machines::Machine& machine);

/// A run at an instruction boundary, with the data collected by observers. A run that continues from it ends as if it
/// had never stopped.
struct Snapshot {
  RunIdentity identity;
  engine::RunState run;
  observe::FrameObserver::Gathered picture;
  observe::Stats stats;

  bool operator==(const Snapshot&) const = default;
};

/// File format of a Snapshot:
///
///     "CSGS", version           5 bytes
///     hashes                    of the Program and of the machine, 8 bytes each
///     the run                   segment, index, whether the segment's end was reported, overflows, skipped
///                               instructions; the answers (count, then 8 per byte); the skips (count, then segment and
///                               index of each); E and every memory bit
///     the picture               colour, depth, owner and, if present, the owner beside Z1; if transparent surfaces
///                               are blended, depth and owner of opaque ones, owner and depth of the others
///     the stats                 the costs in the order of Stats
///     CRC-32 of all the above   4 bytes
///
/// Numbers are varints (LEB128); fixed ones are little-endian. A memory bit is stored as runs of words: 4 * count, plus
/// 0 for words of zeros, 1 for words of ones, 2 for literal words that follow. A part of the picture is stored as runs
/// of pixels: count and value.
std::vector<std::byte> encode(const Snapshot& snapshot);

/// Decodes a checkpoint of that Program and machine; `source_name` begins error messages. Throws InputError if the
/// checkpoint is damaged, belongs to another Program or machine, or has a place, count or value that no run of the
/// Program can reach. Memory use is proportional to the Program's picture.
Snapshot decode(std::span<const std::byte> bytes, std::string_view source_name, const isa::Program& program,
                const machines::Machine& machine);

}  // namespace csgsim::checkpoint
