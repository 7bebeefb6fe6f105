#pragma once

#include <cstdint>
#include <vector>

#include "hw/bit_serial_memory/account.h"
#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/rank_steps.h"
#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/row_listener.h"
#include "hw/bit_serial_memory/slots.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// Analytic timing of row commands in all slots. Clocks count from 0, when the banks are closed and the activation
/// window is empty.
///
/// The controller issues commands in order, and each command to all slots in order: no activation begins before the
/// previous one. Gate and leaf commands are issued to all banks at once; each bank begins when it is free. The commands
/// are complete when the last bank is closed and the activation window is empty again.
class RankTiming {
 public:
  /// `listener`, if not null, receives the commands and refreshes of carry_out() and begin().
  RankTiming(const Figures& figures, const Slots& slots, RowListener* listener = nullptr);

  /// Clocks of the commands if no refresh intervenes.
  std::uint64_t clocks(const RowCommands& commands);

  /// Executes commands from clock `begin` on; a refresh is due every tREFI from the frame's first clock on. It is
  /// performed before the next command that finds the sense amplifiers free: all banks are closed, and everything in
  /// progress is delayed by the refresh. Returns the clock at which the commands end.
  std::uint64_t carry_out(const RowCommands& commands, std::uint64_t begin);

  /// First clock at which commands may begin, if the rank is free from clock `free` on and the commands are available
  /// from `ready` on. Refreshes that fall due until then are performed first.
  std::uint64_t begin(std::uint64_t free, std::uint64_t ready);

  [[nodiscard]] std::uint64_t refreshing() const { return refreshing_; }  ///< total clocks of refreshes
  [[nodiscard]] std::uint64_t refreshes() const { return refreshes_; }

 private:
  void step(const RowCommand& command);
  void refresh_if_due();
  void count_refresh(std::uint64_t clock);

  const RankClocks& rank_;
  RankSteps steps_;
  RowListener* listener_;
  std::vector<Issue> issues_;
  std::uint64_t due_;
  std::uint64_t refreshing_ = 0;
  std::uint64_t refreshes_ = 0;
};

}  // namespace csgsim::bit_serial_memory
