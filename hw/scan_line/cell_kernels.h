#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/scan_line/cell_steps.h"
#include "hw/scan_line/packet.h"

/// Loops over cells, compiled for each vector instruction set and selected at run time.
namespace csgsim::scan_line::kernels {

/// Maximum number of lanes of a vector. Arrays are padded with this number of lanes after the last cell.
inline constexpr std::size_t max_lanes = 8;

/// The cells in [first, end).
struct CellRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

/// State of the cells, one 64-bit lane per cell. Single bits are stored as all ones or all zeros.
struct Lanes {
  std::uint64_t* memory = nullptr;  ///< 64-bit words; word w of all cells precedes word w + 1
  std::size_t stride = 0;           ///< lanes from one word of a cell to the next
  std::uint64_t* enable = nullptr;
  std::array<std::uint64_t*, 2> fetched{};  ///< registers of the fields that were read; roots are computed in the first
  std::uint64_t* value = nullptr;           ///< partial result of the ALU
  std::uint64_t* flags = nullptr;           ///< condition flags of the ALU or of a root (cell_kernels.cpp)
  std::uint64_t* writes = nullptr;          ///< whether the field is written
};

/// Executes consecutive steps of the packet in the cells of the range. Returns the number of cells that were enabled in
/// the acting step.
std::uint64_t execute(const Packet& packet, std::span<const CellStep> steps, const Lanes& lanes, CellRange range);

/// Whether any lane is nonzero.
bool any_ones(std::span<const std::uint64_t> lanes);

/// For each nonzero lane i of the range, sets bit i % 64 of words[i / 64].
void add_bits(const std::uint64_t* lanes, CellRange range, std::span<std::uint64_t> words);

}  // namespace csgsim::scan_line::kernels
