// A field of a tile as one number per pixel.
// Used by memory and the kernels.
#pragma once

#include <array>
#include <cstdint>

#include "hw/isa/instruction.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::functional {

/// The value of a field at every pixel of a tile, block by block and within a block in the order of its bits, with
/// bounds of the values of each block. A block with equal bounds is constant, and its `values` are undefined.
struct Lanes {
  alignas(64) std::array<std::uint32_t, tile_pixels> values;
  alignas(64) std::array<std::uint32_t, blocks_per_tile> least;
  alignas(64) std::array<std::uint32_t, blocks_per_tile> greatest;
  isa::Field field;

  [[nodiscard]] bool is_constant(unsigned block) const { return least[block] == greatest[block]; }
  [[nodiscard]] std::uint32_t* block(unsigned number) { return values.data() + number * block_pixels; }
  [[nodiscard]] const std::uint32_t* block(unsigned number) const { return values.data() + number * block_pixels; }
  [[nodiscard]] std::uint32_t value(unsigned number, unsigned bit) const {
    return is_constant(number) ? least[number] : values[number * block_pixels + bit];
  }
  void set_constant(unsigned number, std::uint32_t value) { least[number] = greatest[number] = value; }
};

}  // namespace csgsim::functional
