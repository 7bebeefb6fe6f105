#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hw/isa/instruction.h"
#include "hw/scan_line/packet.h"

namespace csgsim::scan_line {

/// Part of a field that the ports read or write in one clock.
struct FieldPart {
  isa::Field bits{};       ///< bits of memory; none if the width is 0
  std::uint32_t from = 0;  ///< the bit of the field that corresponds to the lowest of these bits

  constexpr bool operator==(const FieldPart&) const = default;
};

/// Bits that the ALU processes in one clock.
struct AluBits {
  std::uint32_t from = 0;
  std::uint32_t count = 0;  ///< 0: none

  constexpr bool operator==(const AluBits&) const = default;
};

/// Operations of a cell in the clock in which it contains a beat, in this order. All cells execute the same steps.
struct CellStep {
  bool clears = false;               ///< memory and enable become 0
  std::array<FieldPart, 2> reads{};  ///< parts of the sources
  bool begins_root = false;          ///< first trial of a root
  std::uint32_t root_bit = 0;        ///< root bit being tried; the highest is 0
  AluBits trial{};                   ///< bits of the trial's sum
  AluBits alu{};                     ///< bits of the operands
  bool acts = false;                 ///< the enable bit and the values to write become final in this clock
  FieldPart writes{};                ///< part of the target
  bool holds = false;                ///< the hold register stores what was read

  constexpr bool operator==(const CellStep&) const = default;
};

/// Computes the steps of the cells for the packet's beats: the ports read the words of its fields, the shifter moves
/// operands word by word, then the ALU processes their bits, each at its own number of bits per clock. Throws
/// std::logic_error if the packet has a result before all fields are read, the ALU has finished, or the root is
/// complete.
void compute_steps(const Packet& packet, const CellShape& cell, std::vector<CellStep>& steps);

}  // namespace csgsim::scan_line
