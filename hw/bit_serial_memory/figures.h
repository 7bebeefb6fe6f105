#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::bit_serial_memory {

/// Where the logic is, and of which operations an instruction is made.
enum class Design : std::uint8_t {
  and_or_not,  ///< three rows at a time: AND, OR, NOT and XOR, each from rows to a row (Ambit)
  majority,    ///< three rows at a time: majority and NOT, intermediate results staying in the rows for it (SIMDRAM)
  latches,     ///< gates and latches at each sense amplifier (the bit-serial devices of PIMeval)
};

inline constexpr auto design_names = std::to_array<std::string_view>({"and-or-not", "majority", "latches"});

/// How the value of A*x + B*y + C gets into the columns.
enum class Expressions : std::uint8_t {
  rows,    ///< summed there, of the constants and of rows in which each column has its x and y
  planes,  ///< the host works it out and sends its bits, a row each
  trees,   ///< multiplier trees above the sense amplifiers bring it, a bit of each column at a time
};

inline constexpr auto expression_names = std::to_array<std::string_view>({"rows", "planes", "trees"});

/// In clocks; docs/machines/bit-serial-memory.md says what of a memory's timing is in each.
struct CommandClocks {
  std::uint32_t restore = 1;    ///< tRAS: from an activation until its row is restored
  std::uint32_t precharge = 1;  ///< tRP: from there until the next activation of the bank
  std::uint32_t second = 1;     ///< from the first activation of a copy to the second
  std::uint32_t logic = 1;      ///< of gates at the sense amplifiers
  std::uint32_t column = 1;     ///< tRCD: from an activation until bits of the row can be transferred
  std::uint32_t recovery = 0;   ///< from the last bits of a transfer until the row can be closed
  std::uint32_t leaf = 1;       ///< from one bit of the trees to the next
  std::uint32_t global_or = 1;  ///< in which the wired OR settles

  constexpr bool operator==(const CommandClocks&) const = default;
};

/// What all banks share.
struct RankClocks {
  std::uint32_t activation_gap = 1;    ///< tRRD: from one activation to the next
  std::uint32_t window = 0;            ///< tFAW: in which there are four activations at most; 0: any number
  std::uint32_t refresh_interval = 0;  ///< tREFI: from one refresh that is due to the next; 0: none is
  std::uint32_t refresh = 0;           ///< tRFC: of one

  constexpr bool operator==(const RankClocks&) const = default;
};

/// Energies, each of one chip, in femtojoules, and power.
struct Energies {
  std::uint64_t activation_fj = 0;         ///< of a row, with its precharge
  std::uint32_t further_row_permille = 0;  ///< of that, for each further row that is activated with it
  std::uint64_t logic_fj = 0;              ///< of the gates below a column, in a logic command
  std::uint64_t leaf_fj = 0;               ///< of a column's part of the trees, in a command that brings a bit
  std::uint64_t transfer_fj = 0;           ///< of a bit between a row and the host
  std::uint64_t refresh_fj = 0;            ///< of a refresh
  std::uint64_t background_uw = 0;         ///< power whatever it does, µW

  constexpr bool operator==(const Energies&) const = default;
};

/// What only this kind of machine has.
struct Figures {
  Design design = Design::latches;
  Expressions expressions = Expressions::rows;
  bool enable_latch = false;        ///< a column's row is written only where a latch is 1, by the hardware
  bool has_wired_or = false;        ///< of all enable bits, to the controller; else the host reads them
  std::uint32_t chips = 1;          ///< that work in step: of a rank
  std::uint32_t row_bits = 1;       ///< columns of a subarray of a chip
  std::uint32_t subarray_rows = 1;  ///< rows of a subarray
  std::uint32_t banks = 1;          ///< of a chip
  std::uint32_t subarrays = 1;      ///< of a bank
  std::uint32_t bus_bits = 1;       ///< of a row that pass between chips and host in a clock
  std::uint32_t plane_bits = 1;     ///< that the host works out, or turns from rows into pixels, in a clock
  std::uint32_t queue = 1;          ///< commands of the host that wait at the controller
  CommandClocks command;
  RankClocks rank;
  Energies energy;
};

}  // namespace csgsim::bit_serial_memory
