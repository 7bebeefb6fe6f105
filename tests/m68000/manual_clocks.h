#pragma once

#include <array>

#include "tests/m68000/processor.h"

/// Tables of instruction execution times of the MC68000 User's Manual, section 8, in clocks.
namespace csgsim::m68000::manual {

/// Addressing modes in the order of the manual's tables: Dn, An, (An), (An)+, -(An), d16(An), d8(An,Xn), (xxx).W,
/// (xxx).L, d16(PC), d8(PC,Xn), #<data>.
inline constexpr std::size_t modes = 12;
using Row = std::array<unsigned, modes>;

constexpr std::size_t mode_index(unsigned mode, unsigned reg) { return mode < 7 ? mode : std::size_t{7} + reg; }

/// Effective address calculation for bytes and words.
inline constexpr Row effective_address{0, 0, 4, 4, 6, 8, 10, 8, 12, 8, 10, 4};
/// Effective address calculation for longs.
inline constexpr Row effective_address_long{0, 0, 8, 8, 10, 12, 14, 12, 16, 12, 14, 8};
/// Clocks that a destination adds to MOVE of bytes and words.
inline constexpr Row move_to{0, 0, 4, 4, 4, 8, 10, 8, 12, 0, 0, 0};
/// Clocks that a destination adds to MOVE of longs.
inline constexpr Row move_to_long{0, 0, 8, 8, 8, 12, 14, 12, 16, 0, 0, 0};
/// An entry of 0 means that the instruction does not exist.
inline constexpr Row lea{0, 0, 4, 0, 0, 8, 12, 8, 12, 8, 12, 0};
inline constexpr Row pea{0, 0, 12, 0, 0, 16, 20, 16, 20, 16, 20, 0};
inline constexpr Row jmp{0, 0, 8, 0, 0, 10, 14, 10, 12, 10, 14, 0};
inline constexpr Row jsr{0, 0, 16, 0, 0, 18, 22, 18, 20, 18, 22, 0};
/// MOVEM to registers and from them, in addition to 4 clocks per word and 8 per long.
inline constexpr Row movem_load{0, 0, 12, 12, 0, 16, 18, 16, 20, 16, 18, 0};
inline constexpr Row movem_store{0, 0, 8, 0, 8, 12, 14, 12, 16, 0, 0, 0};

constexpr unsigned address_clocks(unsigned mode, unsigned reg, Size size) {
  return (size == Size::longword ? effective_address_long : effective_address)[mode_index(mode, reg)];
}

}  // namespace csgsim::m68000::manual
