#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

/// All of a Program but its instructions, with the number of them in each segment, as CBOR.
std::vector<std::uint8_t> encode_metadata(const Program& program);

struct Metadata {
  Program program;                                ///< its segments have no instructions yet
  std::vector<std::uint64_t> instruction_counts;  ///< of each segment; as claimed, not checked
};

/// Metadata of before Programs named their machine and what is shown is told so; its rows' extents are left out. Throws
/// MalformedBytes.
Metadata decode_metadata(std::span<const std::byte> cbor, bool names_machine);

}  // namespace csgsim::isa
