#pragma once

#include <cstdint>
#include <vector>

#include "hw/bit_serial_memory/micro_program.h"
#include "hw/bit_serial_memory/subarray.h"
#include "hw/isa/instruction.h"
#include "sim/reference/reference_array.h"

namespace csgsim::testing {

/// A subarray with one pixel per column, whose rows and latches the test can set and read.
class Columns {
 public:
  Columns(isa::ArrayShape shape, const bit_serial_memory::MicroDesign& design);

  /// Copies memory and enable bit of every pixel.
  void set(const reference::ReferenceArray& pixels);

  /// Executes the commands; the host or the trees supply the bits of the expression.
  void execute(const bit_serial_memory::RowCommands& commands, const isa::Linear& linear);

  [[nodiscard]] bool memory_bit(std::uint32_t bit, std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] bool enabled(std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] const bit_serial_memory::RowMap& map() const { return map_; }
  [[nodiscard]] const bit_serial_memory::MicroDesign& design() const { return design_; }

 private:
  template <class BitOf>
  [[nodiscard]] bit_serial_memory::RowWords words_of(const BitOf& bit_of) const;
  [[nodiscard]] bool bit(std::span<const std::uint64_t> words, std::uint32_t x, std::uint32_t y) const;

  isa::ArrayShape shape_;
  bit_serial_memory::MicroDesign design_;
  bit_serial_memory::RowMap map_;
  bit_serial_memory::Subarray subarray_;
};

/// Every design with each source of expressions, with and without the latch for writes and the wired OR.
std::vector<bit_serial_memory::MicroDesign> all_designs();

/// Number of commands with the given op.
std::size_t count_of(bit_serial_memory::RowOp op, const bit_serial_memory::RowCommands& commands);

}  // namespace csgsim::testing
