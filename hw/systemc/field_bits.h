// Reads and writes fields in word-organized pixel memory.
// Used by hw/scan_line and hw/multi_processor.
#pragma once

#include <cstdint>
#include <span>

#include "hw/isa/instruction.h"

namespace csgsim::systemc {

/// The value of a field in a pixel's memory, where bit b is bit b % 64 of word b / 64. 0 for a field of width 0.
inline std::uint64_t read_field(std::span<const std::uint64_t> memory, isa::Field field) {
  if (field.width == 0) return 0;
  const unsigned word = field.base / 64U;
  const unsigned shift = field.base % 64U;
  std::uint64_t value = memory[word] >> shift;
  if (shift + field.width > 64) value |= memory[word + 1] << (64 - shift);
  return value & ((std::uint64_t{1} << field.width) - 1);
}

/// Stores the low bits of a value in the field.
inline void write_field(std::span<std::uint64_t> memory, isa::Field field, std::uint64_t value) {
  const std::uint64_t mask = (std::uint64_t{1} << field.width) - 1;
  const unsigned word = field.base / 64U;
  const unsigned shift = field.base % 64U;
  value &= mask;
  memory[word] = (memory[word] & ~(mask << shift)) | value << shift;
  if (shift + field.width <= 64) return;
  memory[word + 1] = (memory[word + 1] & ~(mask >> (64 - shift))) | value >> (64 - shift);
}

}  // namespace csgsim::systemc
