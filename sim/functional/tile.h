// A tile of pixels: memory, enable and the execution of instructions.
// Used by tiles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"
#include "sim/engine/work.h"
#include "sim/functional/lane_kernels.h"
#include "sim/functional/linear_kernels.h"
#include "sim/functional/memory.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::functional {

/// Up to 64 x 64 pixels of a segment: memory and enable. The time of an instruction is proportional to the number of
/// blocks of 8 x 8 pixels that are not uniform. Tiles of a segment share nothing.
class alignas(64) Tile {
 public:
  /// (x, y) is the position of the tile's first pixel in the segment.
  Tile(std::uint32_t x, std::uint32_t y, TileShape shape, std::uint32_t memory_bits, Decide decide);

  /// Clears memory and enable, as at the start of a segment.
  void clear();

  /// Executes one valid instruction. Returns the number of enabled pixels at which its
  /// linear or quadratic expression exceeded its width.
  std::uint64_t execute(const isa::Instruction& instruction);

  [[nodiscard]] std::uint32_t x() const { return x_; }
  [[nodiscard]] std::uint32_t y() const { return y_; }
  [[nodiscard]] const TileShape& shape() const { return shape_; }
  [[nodiscard]] const engine::Work& work() const { return work_; }

  /// Number of pixels whose E is 1.
  [[nodiscard]] std::uint32_t enabled() const { return enabled_; }

  [[nodiscard]] const Memory& memory() const { return memory_; }
  [[nodiscard]] const TileBits& enable() const { return enable_; }
  /// Reads a bit of memory as Memory::read does.
  [[nodiscard]] const TileBits& bit(unsigned number, TileBits& copy) const {
    return memory_.read(number, shape_.blocks(), copy);
  }
  /// Sets E, or a bit of memory, from rows of 64 pixels in the format of read_rows.
  void write_enable(const std::uint64_t* rows, std::size_t stride);
  void write_bit(unsigned bit, const std::uint64_t* rows, std::size_t stride);

  /// The field's value at one pixel of the tile.
  [[nodiscard]] std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const {
    return memory_.value(field, x, y);
  }
  [[nodiscard]] bool is_enabled(std::uint32_t x, std::uint32_t y) const {
    return (enable_.word(block_of(x, y), shape_) >> bit_of(x, y) & 1U) != 0;
  }

 private:
  /// The blocks on which an instruction works that reads the old values of its target.
  [[nodiscard]] TargetBlocks blocks_to_update() const { return {enable_.any(), 0}; }
  /// The blocks on which an instruction works that does not read the old values of its target; it overwrites all pixels
  /// of full blocks.
  [[nodiscard]] TargetBlocks blocks_to_overwrite() const { return {enable_.any(), enable_.full()}; }
  [[nodiscard]] EnabledPixels pixels() { return {enable_, shape_, decide_, work_}; }

  void invert_enable();
  void combine_enable(isa::Opcode opcode, unsigned bit);
  std::uint64_t execute_linear(const isa::Instruction& instruction, LinearKind kind);
  LinearResult execute_quadratic(const isa::Instruction& instruction, const isa::Linear& squares, LinearKind kind);
  void root(isa::Field target);

  void set_constant(isa::Field target, std::uint64_t constant);
  void copy(isa::Field target, isa::Field source);
  [[nodiscard]] bool has_same_parts(isa::Field source, isa::Field target, const std::vector<isa::Field>& parts) const;
  void compare(Comparison comparison, isa::Field left, isa::Field right);
  void compare_bits(Comparison comparison, isa::Field left, isa::Field right);
  /// Combines each bit of one field or of two with the target.
  template <class Combine>
  void combine_bits(Combine combine, isa::Field target, isa::Field left, isa::Field right);
  void add(isa::Field target, isa::Field source);
  void add_bits(isa::Field target, isa::Field source);
  void xor_constant(isa::Field target, std::uint64_t constant);
  [[nodiscard]] bool is_faster_by_bits(isa::Field target, isa::Field source) const;

  std::uint32_t x_;
  std::uint32_t y_;
  TileShape shape_;
  Decide decide_;
  Memory memory_;
  TileBits enable_;
  std::uint32_t enabled_ = 0;
  isa::Linear squares_;  ///< coefficients added to the next instruction's sum
  engine::Work work_;
  TileBits first_copy_;   ///< bits read from lanes
  TileBits second_copy_;  ///< bits read from lanes
};

}  // namespace csgsim::functional
