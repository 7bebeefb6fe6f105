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
///     size, metadata            varint, then CBOR: all of the Program but its instructions, with their counts
///     instructions              of every segment, in order
///     CRC-32 of all the above   4 bytes, the least significant first
///
/// An instruction is its opcode's number, plus 128 if its origin is that of the instruction before; else the origin
/// follows: purpose, primitive + 1 and node + 1, 0 for none. Then its operands as the opcode table lists them: a field
/// is base and width; a linear expression A, B, C (zigzag), width and shift; a constant or a count itself. All are
/// varints (LEB128).
std::vector<std::byte> encode(const Program& program);

/// Does a file that begins so claim to be of the binary form?
bool is_binary(std::span<const std::byte> bytes);

/// Reads the binary form; `name` stands in front of errors. The result is valid. Throws InputError: truncated, wrong
/// magic, version or checksum, undefined opcode, bytes left over, not a valid Program. Takes memory in proportion to
/// the bytes, whatever counts they claim.
Program decode(std::span<const std::byte> bytes, std::string_view name);

}  // namespace csgsim::isa
