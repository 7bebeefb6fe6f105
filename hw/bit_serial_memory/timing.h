#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hw/bit_serial_memory/account.h"
#include "hw/bit_serial_memory/figures.h"
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
  void start(std::uint64_t clock);
  [[nodiscard]] std::uint64_t next_activation(std::uint64_t bank) const;
  void activate(std::uint64_t clock);
  void issue(const RowCommand& command, std::uint64_t slot);
  void issue_to_all(const RowCommand& command);
  void refresh_before(const RowCommand& command);
  void shift(std::uint64_t clocks);
  [[nodiscard]] std::uint64_t over() const;

  const Figures& figures_;
  const Slots slots_;
  bool refreshes_come_ = false;
  std::uint64_t due_ = 0;
  std::uint64_t refreshing_ = 0;
  std::uint64_t refreshes_ = 0;
  std::uint64_t start_ = 0;
  std::vector<std::uint64_t> free_;         ///< each bank
  std::array<std::uint64_t, 4> allowed_{};  ///< of the next four activations, in a ring, by the window
  std::size_t next_ = 0;                    ///< in it
  std::uint64_t last_ = 0;                  ///< the next activation is allowed by the one before
  std::uint64_t bus_ = 0;                   ///< free
};

}  // namespace csgsim::bit_serial_memory
