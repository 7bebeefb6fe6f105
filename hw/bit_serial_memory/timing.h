#pragma once

#include <cstdint>

#include "hw/bit_serial_memory/account.h"
#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/rank_steps.h"
#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/slots.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// Analytic timing of row commands in all slots. Clocks count from 0, when the banks are closed and the activation
/// window is empty.
///
/// The controller issues each command to all slots in order, and commands in order: no activation begins before its
/// predecessor. Gate and leaf commands are issued to all banks at once; each bank begins when it is free. The commands
/// are complete when the last bank is closed and the activation window is empty again.
class RankTiming {
 public:
  RankTiming(const Figures& figures, const Slots& slots);

  /// Clocks of the commands if no refresh intervenes.
  std::uint64_t clocks(const RowCommands& commands);

  /// Executes commands from clock `begin` on, with refreshes due every tREFI from the frame's first clock. A refresh is
  /// performed before a command that finds the sense amplifiers free: all banks are closed, and everything in progress
  /// is delayed by the refresh. Returns the clock of the end.
  std::uint64_t carry_out(const RowCommands& commands, std::uint64_t begin);

  /// First clock from `ready` on at which commands may begin, after performing refreshes that are due before.
  std::uint64_t begin(std::uint64_t free, std::uint64_t ready);

  [[nodiscard]] std::uint64_t refreshing() const { return refreshing_; }  ///< total clocks of refreshes
  [[nodiscard]] std::uint64_t refreshes() const { return refreshes_; }

 private:
  void refresh_if_due();

  const RankClocks& rank_;
  RankSteps steps_;
  std::uint64_t due_;
  std::uint64_t refreshing_ = 0;
  std::uint64_t refreshes_ = 0;
};

}  // namespace csgsim::bit_serial_memory
