#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"

namespace csgsim::scan_line {

/// The field's value in a cell's memory: bit b of it is bit b % 64 of word b / 64. 0 for a field without bits.
inline std::uint64_t read_field(std::span<const std::uint64_t> memory, isa::Field field) {
  if (field.width == 0) return 0;
  const unsigned word = field.base / 64U;
  const unsigned shift = field.base % 64U;
  std::uint64_t value = memory[word] >> shift;
  if (shift + field.width > 64) value |= memory[word + 1] << (64 - shift);
  return value & ((std::uint64_t{1} << field.width) - 1);
}

/// Cells of a line as a packet left them, each at its own clock.
struct Snapshot {
  std::size_t cell_words = 0;         ///< 64-bit words of a cell's memory
  std::vector<std::uint64_t> memory;  ///< cell_words a cell; empty if not kept
  std::vector<std::uint64_t> enable;  ///< 64 cells a word; empty if not kept

  [[nodiscard]] std::uint64_t read(std::size_t cell, isa::Field field) const {
    return read_field(std::span(memory).subspan(cell * cell_words, cell_words), field);
  }
};

}  // namespace csgsim::scan_line
