// Reads and writes the binary form of Programs (.csgt).
// Used by program_file.cpp, sim/checkpoint, sim/session, sim/viewer and sim/app.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

/// The binary form of a Program, as in a .csgt file:
///
///     "CSGT", version           5 bytes
///     size, metadata            varint, then CBOR: the Program without its instructions, with their counts
///     instructions              all segments, in order
///     CRC-32                    4 bytes, over everything above, least significant first
///
/// An instruction is its opcode number, plus 128 if it has the same origin as the previous instruction; otherwise the
/// origin follows: purpose, primitive + 1 and node + 1, with 0 for none. Then come the operands in the order of the
/// opcode table: base and width of a field; A, B, C (zigzag), width and shift of a linear expression; a constant or
/// count itself. All are varints (LEB128).
std::vector<std::byte> encode(const Program& program);

/// Whether the bytes begin with the magic of the binary form.
bool is_binary(std::span<const std::byte> bytes);

/// Reads the binary form; `name` precedes error texts. The result is valid. Throws InputError for a truncated file, a
/// wrong magic, version or checksum, an undefined opcode, trailing bytes, or an invalid Program. Memory use is
/// proportional to the number of bytes, whatever counts they claim.
Program decode(std::span<const std::byte> bytes, std::string_view name);

}  // namespace csgsim::isa
