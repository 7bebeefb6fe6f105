#pragma once

#include <array>
#include <cstdint>

#include "hw/isa/instruction.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::functional {

/// A field's value at every pixel of a tile, block after block and in a block as its bits are, with bounds of the
/// values of each block. Where both bounds of a block are equal it is constant, and what `values` holds there is
/// nothing.
struct Lanes {
  alignas(64) std::array<std::uint32_t, tile_pixels> values;
  alignas(64) std::array<std::uint32_t, blocks_a_tile> least;
  alignas(64) std::array<std::uint32_t, blocks_a_tile> greatest;
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
