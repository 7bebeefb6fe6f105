#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hw/isa/instruction.h"
#include "hw/scan_line/packet.h"

namespace csgsim::scan_line {

/// What of a field the ports read or write in a clock.
struct FieldPart {
  isa::Field bits{};       ///< of memory; none if it has no width
  std::uint32_t from = 0;  ///< bit of the field that is the lowest of them

  constexpr bool operator==(const FieldPart&) const = default;
};

/// Bits that the ALU goes through in a clock.
struct AluBits {
  std::uint32_t from = 0;
  std::uint32_t count = 0;  ///< 0: none

  constexpr bool operator==(const AluBits&) const = default;
};

/// What each cell does in the clock in which a beat is in it, in this order. Every cell does the same.
struct CellStep {
  bool clears = false;               ///< memory and enable become 0
  std::array<FieldPart, 2> reads{};  ///< of the sources
  bool begins_root = false;          ///< the first of its trials
  std::uint32_t root_bit = 0;        ///< that is tried, the highest is 0
  AluBits trial{};                   ///< of the sum of its trial
  AluBits alu{};                     ///< of the operands
  bool acts = false;                 ///< enable bit and what is written are there at the end of the clock
  FieldPart writes{};                ///< of the target
  bool holds = false;                ///< the hold register takes what has been read

  constexpr bool operator==(const CellStep&) const = default;
};

/// What cells do with the packet's beats: the ports go through the words of its fields, the shifter moves operands word
/// by word, then the ALU goes through their bits, each as wide as it is. Throws std::logic_error if the packet has a
/// result before a field has been read, the ALU is through, or a root is complete.
void find_steps(const Packet& packet, const CellShape& cell, std::vector<CellStep>& steps);

}  // namespace csgsim::scan_line
