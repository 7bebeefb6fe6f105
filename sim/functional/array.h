#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"
#include "sim/functional/bit_plane.h"
#include "sim/functional/memory.h"

namespace csgsim::sim {

/// A band of rows of a segment's pixels: memory and enable, worked on a word of pixels at a time. An instruction costs
/// time for the rectangle of pixels it can change only. Bands of one segment share nothing.
class Array {
 public:
  /// Rows [first_row, first_row + rows) of a segment `width` pixels wide.
  Array(std::uint32_t width, std::uint32_t first_row, std::uint32_t rows, std::uint32_t memory_bits);

  /// Memory and enable 0, as a segment begins.
  void clear();

  /// Carries out one valid instruction. Returns the number of enabled pixels at which A*x + B*y + C did not fit its
  /// width, but had to.
  std::uint64_t execute(const isa::Instruction& instruction);

  [[nodiscard]] std::uint32_t first_row() const { return first_row_; }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }
  [[nodiscard]] std::uint32_t width() const { return width_; }

  /// Pixels whose E is 1.
  [[nodiscard]] std::uint64_t enabled() const { return enabled_; }

  /// The field's value at every pixel of the band, in row order.
  void read_field(isa::Field field, std::span<std::uint32_t> values) const { memory_.values(field, values); }

  /// Enable bits, 64 pixels a word, rows padded with zeros to whole words.
  void read_enable(std::span<std::uint64_t> words) const;

 private:
  [[nodiscard]] Rect whole() const { return enable_.whole(); }
  /// E's words, written out and within its bounds.
  WordBlock enable_block();
  void recount() { enabled_ = settle(enable_); }

  void invert_enable();
  void combine_enable(isa::Opcode opcode, unsigned bit);
  std::uint64_t execute_linear(const isa::Instruction& instruction);
  std::uint64_t execute_on_linear_kernel(const isa::Instruction& instruction, bool wraps);
  [[nodiscard]] bool can_wrap(const isa::Linear& linear) const;

  void set_constant(isa::Field target, std::uint64_t constant);
  void copy(isa::Field target, isa::Field source);
  [[nodiscard]] bool has_parts_of(isa::Field source, isa::Field target, const std::vector<isa::Field>& parts) const;
  void compare(isa::Opcode opcode, isa::Field left, isa::Field right);
  void combine_bits(const isa::Instruction& instruction);
  void combine_bit(isa::Opcode opcode, unsigned target, unsigned left, unsigned right);
  void add(isa::Field target, isa::Field source);
  void add_bits(isa::Field target, isa::Field source);
  void xor_constant(isa::Field target, std::uint64_t constant);
  [[nodiscard]] bool as_bits(isa::Field first, isa::Field second) const;

  std::uint32_t width_;
  std::uint32_t first_row_;
  std::uint32_t rows_;
  Memory memory_;
  BitPlane enable_;
  std::uint64_t enabled_ = 0;
  BitPlane first_copy_;   ///< bits read from lanes
  BitPlane second_copy_;  ///< bits read from lanes
};

}  // namespace csgsim::sim
