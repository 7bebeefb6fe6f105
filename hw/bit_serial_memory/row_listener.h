// Observer of a frame's row commands and their clocks.
// Used by the analytic timing and sim/rows.
#pragma once

#include <cstdint>
#include <span>

#include "hw/bit_serial_memory/row_command.h"
#include "hw/isa/instruction.h"

namespace csgsim::bit_serial_memory {

/// Clocks of a command in one slot or, for a command without activation, in one bank. Clocks count from the frame's
/// first.
struct Issue {
  std::uint64_t place = 0;            ///< index of the slot or bank
  std::uint64_t clock = 0;            ///< the first activation, or the first clock of the gates
  std::uint64_t second = 0;           ///< copy only: activation of the rows `to`
  std::uint64_t transfer = 0;         ///< receive and send only: first clock of the row's bits on the bus
  std::uint64_t transfer_clocks = 0;  ///< receive and send only
  std::uint64_t precharge = 0;        ///< the bank begins to close; 0 for a command without activation
};

/// Receives the row commands that a frame executes, in the order of the Program. Functions do nothing by default.
class RowListener {
 public:
  RowListener() = default;
  RowListener(const RowListener&) = delete;
  RowListener& operator=(const RowListener&) = delete;
  virtual ~RowListener() = default;

  /// The following commands clear the pixel memory of a segment.
  virtual void begin_segment(std::uint32_t /*segment*/) {}
  /// The following commands are those of an instruction. `number`: its index in the whole Program.
  virtual void begin_instruction(std::uint64_t /*number*/, const isa::Instruction& /*instruction*/) {}
  /// The following commands send the picture to the host.
  virtual void begin_scan_out() {}
  /// All banks are refreshed from `clock` on.
  virtual void refresh(std::uint64_t /*clock*/) {}
  /// A command with its clocks in every slot or bank, in the order of issue.
  virtual void command(const RowCommand& /*command*/, std::span<const Issue> /*issues*/) {}
};

}  // namespace csgsim::bit_serial_memory
