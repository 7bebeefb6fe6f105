#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/scan_line/cell_steps.h"
#include "hw/scan_line/packet.h"

/// The loops over cells, compiled for every vector unit and chosen at run time.
namespace csgsim::scan_line::kernels {

/// Behind the last cell lanes have room for so many more.
inline constexpr std::size_t most_lanes = 8;

/// Cells from `first` to before `end`.
struct CellRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

/// What cells hold, a lane for each. Single bits are all ones or all zeros.
struct Lanes {
  std::uint64_t* memory = nullptr;  ///< 64 bits of every cell, then the next
  std::size_t stride = 0;           ///< lanes from these to those
  std::uint64_t* enable = nullptr;
  std::array<std::uint64_t*, 2> fetched{};  ///< fields that have been read; a root is taken in the first
  std::uint64_t* value = nullptr;           ///< what the ALU has made of the operands so far
  std::uint64_t* flags = nullptr;           ///< and found (cell_kernels.cpp), or of a root
  std::uint64_t* writes = nullptr;          ///< whether F is written
};

/// Cells of the range carry out steps of the packet, one after the other. Returns how many were enabled when they
/// acted.
std::uint64_t carry_out(const Packet& packet, std::span<const CellStep> steps, const Lanes& lanes, CellRange range);

/// Whether any lane is not 0.
bool any_ones(std::span<const std::uint64_t> lanes);

/// Of the lanes of the range that are not 0, lane i sets bit i % 64 of word i / 64.
void add_bits(const std::uint64_t* lanes, CellRange range, std::span<std::uint64_t> words);

}  // namespace csgsim::scan_line::kernels
