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

/// Hashes that tell what a run is of; no defence against forgery.
struct RunIdentity {
  std::uint64_t program = 0;  ///< of its binary form
  std::uint64_t machine = 0;  ///< of its hardware; names and sources do not matter

  constexpr bool operator==(const RunIdentity&) const = default;
};

RunIdentity identity_of(const isa::Program& program, const machines::Machine& machine);

/// A run at an instruction boundary, with what has been gathered of it. A run that goes on from it ends as if it had
/// never stopped.
struct Snapshot {
  RunIdentity identity;
  engine::RunState run;
  observe::FrameObserver::Gathered picture;
  observe::Stats stats;

  bool operator==(const Snapshot&) const = default;
};

/// The form of a Snapshot in a file:
///
///     "CSGS", version           5 bytes
///     hashes                    of the Program and of the machine, 8 bytes each
///     the run                   segment, index, whether the segment's end was told, overflows, instructions skipped;
///                               the answers (their count, then 8 a byte); the skips (their count, then segment and
///                               index of each); E and every memory bit
///     the picture               colour, depth, owner and, where there is one, the owner beside Z1; where see-through
///                               surfaces are blended, depth and owner of opaque ones, owner and depth of the others
///     the stats                 the costs in the order of Stats
///     CRC-32 of all the above   4 bytes
///
/// Numbers are varints (LEB128), fixed ones have their low bytes first. A memory bit is runs of words: 4 * count, plus
/// 0 for words of zeros, 1 for words of ones, 2 for words that follow. A part of the picture is runs of pixels: count
/// and value.
std::vector<std::byte> encode(const Snapshot& snapshot);

/// Reads it for that Program and machine; `name` stands in front of errors. Throws InputError: damaged, of another
/// Program or machine, or not a state that a run of the Program can be in, as far as places, counts and ranges tell.
/// Takes memory in proportion to the Program's picture.
Snapshot decode(std::span<const std::byte> bytes, std::string_view name, const isa::Program& program,
                const machines::Machine& machine);

}  // namespace csgsim::checkpoint
