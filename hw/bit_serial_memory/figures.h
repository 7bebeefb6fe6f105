#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::bit_serial_memory {

/// Location of the logic, and operations from which instructions are composed.
enum class Design : std::uint8_t {
  and_or_not,  ///< three rows at a time: AND, OR, NOT and XOR, each from rows to a row (Ambit)
  majority,    ///< three rows at a time: majority and NOT, with intermediate results kept in the compute rows (SIMDRAM)
  latches,     ///< gates and latches at each sense amplifier (the bit-serial devices of PIMeval)
};

inline constexpr auto design_names = std::to_array<std::string_view>({"and-or-not", "majority", "latches"});

/// Source of A*x + B*y + C at the columns.
enum class Expressions : std::uint8_t {
  rows,    ///< summed in the columns from constants and from rows that hold each column's x and y
  planes,  ///< computed by the host, which sends the bits, one row each
  trees,   ///< delivered by multiplier trees above the sense amplifiers, one bit of every column at a time
};

inline constexpr auto expression_names = std::to_array<std::string_view>({"rows", "planes", "trees"});

/// Command timing in clocks; docs/machines/bit-serial-memory.md maps the members to a memory's timing parameters.
struct CommandClocks {
  std::uint32_t restore = 1;    ///< tRAS: from an activation until its row is restored
  std::uint32_t precharge = 1;  ///< tRP: from the restored row until the bank's next activation
  std::uint32_t second = 1;     ///< clocks from the first activation of a copy to the second
  std::uint32_t logic = 1;      ///< clocks of gates at the sense amplifiers
  std::uint32_t column = 1;     ///< tRCD: from an activation until bits of the row can be transferred
  std::uint32_t recovery = 0;   ///< clocks from the last bits of a transfer until the row can be closed
  std::uint32_t leaf = 1;       ///< clocks from one bit of the trees to the next
  std::uint32_t global_or = 1;  ///< settling time of the wired OR

  constexpr bool operator==(const CommandClocks&) const = default;
};

/// Timing shared by all banks, in clocks.
struct RankClocks {
  std::uint32_t activation_gap = 1;    ///< tRRD: minimum from one activation to the next
  std::uint32_t window = 0;            ///< tFAW: window with at most four activations; 0: no limit
  std::uint32_t refresh_interval = 0;  ///< tREFI: from one due refresh to the next; 0: no refreshes
  std::uint32_t refresh = 0;           ///< tRFC: duration of a refresh

  constexpr bool operator==(const RankClocks&) const = default;
};

/// Energies per chip in femtojoules, and power.
struct Energies {
  std::uint64_t activation_fj = 0;  ///< activation of a row, including its precharge
  /// Energy of each further row activated at the same time, in thousandths of activation_fj.
  std::uint32_t further_row_permille = 0;
  std::uint64_t logic_fj = 0;       ///< gates below one column, per logic command
  std::uint64_t leaf_fj = 0;        ///< one column's part of the trees, per delivered bit
  std::uint64_t transfer_fj = 0;    ///< transfer of one bit between a row and the host
  std::uint64_t refresh_fj = 0;     ///< one refresh
  std::uint64_t background_uw = 0;  ///< background power in µW, regardless of activity

  constexpr bool operator==(const Energies&) const = default;
};

/// Parameters that only this kind of machine has.
struct Figures {
  Design design = Design::latches;
  Expressions expressions = Expressions::rows;
  bool enable_latch = false;  ///< hardware write mask: a column's row is written only where a latch is 1
  /// Whether a wired OR of all enable bits reports to the controller; otherwise the host reads the bits.
  bool has_wired_or = false;
  std::uint32_t chips = 1;          ///< chips of a rank, which work in lockstep
  std::uint32_t row_bits = 1;       ///< columns of a chip's subarray
  std::uint32_t subarray_rows = 1;  ///< rows of a subarray
  std::uint32_t banks = 1;          ///< banks of a chip
  std::uint32_t subarrays = 1;      ///< subarrays of a bank
  std::uint32_t bus_bits = 1;       ///< bits of a row transferred between a chip and the host per clock
  std::uint32_t plane_bits = 1;     ///< bits per clock that the host computes, or converts from rows to pixels
  std::uint32_t queue = 1;          ///< host commands that can wait at the controller
  CommandClocks command;
  RankClocks rank;
  Energies energy;
};

}  // namespace csgsim::bit_serial_memory
