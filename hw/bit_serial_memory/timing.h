#pragma once

#include <cstdint>

#include "hw/bit_serial_memory/account.h"
#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/rank_steps.h"
#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/slots.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// When row commands are carried out by all slots, worked out without stepping. Clocks count from 0; the banks are
/// closed then, and as many activations allowed as there can be.
///
/// The controller goes through the slots with each command, and from command to command in order: no activation
/// begins before the one that comes before it. Gates and leaves are told to all banks at once, each of which begins
/// when it is free. All is over when the last bank is closed and activations are allowed as in the beginning.
class RankTiming {
 public:
  RankTiming(const Figures& figures, const Slots& slots);

  /// Clocks of the commands, if no refresh comes between.
  std::uint64_t clocks(const RowCommands& commands);

  /// Beginning with that clock, when refreshes are due every tREFI from the frame's first clock on. A refresh is waited
  /// for where it finds the sense amplifiers free: all banks are closed, and what was going on goes on later by as much
  /// as it took. Returns the clock at the end.
  std::uint64_t carry_out(const RowCommands& commands, std::uint64_t begin);

  /// The first clock from `ready` on at which commands may begin; what is due before has been refreshed then.
  std::uint64_t begin(std::uint64_t free, std::uint64_t ready);

  [[nodiscard]] std::uint64_t refreshing() const { return refreshing_; }  ///< clocks, so far
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
