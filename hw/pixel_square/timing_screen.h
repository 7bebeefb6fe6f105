#pragma once

#include <cstdint>
#include <optional>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/timing_agenda.h"

namespace csgsim::pixel_square {

/// Edge-level model of the turns in which the screen reads the frame buffer. Turn k, from 1, begins at the first edge e
/// for which e / (clocks per second) >= k / (turns per second).
class ScreenTiming {
 public:
  ScreenTiming(const isa::Program& program, const machines::Machine& machine);

  /// The bank that a turn occupies in the clock that begins with edge `now`; empty if no turn does. `now` must not
  /// decrease from call to call.
  [[nodiscard]] std::optional<std::uint32_t> occupied_bank(Time now);

  /// Number of clocks occupied by turns, up to and including the clock that begins with edge `last_edge`.
  [[nodiscard]] std::uint64_t clocks_until(Time last_edge) const;

 private:
  [[nodiscard]] std::uint64_t turns_until(Time now) const;
  [[nodiscard]] Time turn_start(std::uint64_t turn) const;
  void advance_to_turn(std::uint64_t turn);

  std::uint64_t turns_per_picture_;
  std::uint64_t turns_per_second_;
  std::uint64_t clock_hz_;
  std::uint64_t turn_clocks_;
  std::uint64_t turn_bits_;
  std::uint64_t row_bits_;
  std::uint32_t banks_;

  // State of the turn that was requested last.
  std::uint32_t bank_ = 0;
  Time end_ = 0;   ///< first edge after the turn; 0 if there is none
  Time next_ = 0;  ///< edge at which the next turn begins
};

}  // namespace csgsim::pixel_square
