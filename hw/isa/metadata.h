// CBOR metadata of the binary form.
// Used by binary.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

/// Encodes a Program without its instructions, but with their number in each segment, as CBOR.
std::vector<std::uint8_t> encode_metadata(const Program& program);

struct Metadata {
  Program program;                                ///< without instructions
  std::vector<std::uint64_t> instruction_counts;  ///< one per segment, as claimed by the file
};

/// Decodes metadata. `names_machine` is false for the old version, which names neither the machine nor the displayed
/// field; the row extents of such a Program are left empty. Throws MalformedBytes.
Metadata decode_metadata(std::span<const std::byte> cbor, bool names_machine);

}  // namespace csgsim::isa
