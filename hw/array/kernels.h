#pragma once

#include <cstddef>
#include <cstdint>

#include "hw/array/array_step.h"

/// The loops over whole planes, compiled for every vector unit and chosen at run time.
namespace csgsim::array::kernels {

/// The planes of one bit of a step. Operands that the function does not use may be null. `words` is a multiple of 8.
struct AluPlanes {
  const std::uint64_t* x = nullptr;
  const std::uint64_t* y = nullptr;
  const std::uint64_t* present = nullptr;
  std::uint64_t* enable = nullptr;
  std::uint64_t* carry = nullptr;
  std::uint64_t* latch = nullptr;
  std::uint64_t* write = nullptr;
  bool constant = false;
  std::size_t words = 0;
};

/// One bit of what every pixel's ALU does in a clock.
void alu_step(AluFunction function, const AluPlanes& planes);

/// One clock of one level of the Y tree. Node p's stream is row p of `in`; its left child (row 2p of `out`) gets it
/// as it is, its right child (row 2p + 1) gets in + multiplicand + carry. Rows hold `row_words` words; the last node
/// has a right child only if `right_children` == `nodes`.
struct TreeLevel {
  const std::uint64_t* in = nullptr;
  std::uint64_t* carry = nullptr;
  std::uint64_t* out = nullptr;
  std::size_t nodes = 0;
  std::size_t right_children = 0;
  std::size_t row_words = 0;
};

/// `first`: the carries start from 0. `multiplicand`: the bit on the level's broadcast wire.
void tree_level_step(const TreeLevel& level, bool first, bool multiplicand);

/// Ones in `words` words (a multiple of 8).
std::uint64_t count_ones(const std::uint64_t* plane, std::size_t words);

/// Whether any bit of `words` words (a multiple of 8) is 1.
bool any_ones(const std::uint64_t* plane, std::size_t words);

}  // namespace csgsim::array::kernels
