#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"
#include "hw/systemc/field_bits.h"

namespace csgsim::scan_line {

/// State of the cells of a line as a packet left them. The packet leaves each cell in a different clock.
struct Snapshot {
  std::size_t cell_words = 0;         ///< 64-bit words of a cell's memory
  std::vector<std::uint64_t> memory;  ///< cell_words words per cell; empty if not kept
  std::vector<std::uint64_t> enable;  ///< 64 cells per word; empty if not kept

  [[nodiscard]] std::uint64_t read(std::size_t cell, isa::Field field) const {
    return systemc::read_field(std::span(memory).subspan(cell * cell_words, cell_words), field);
  }
};

}  // namespace csgsim::scan_line
