#pragma once

#include <cstdint>
#include <optional>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/timing_agenda.h"

namespace csgsim::pixel_square {

/// What the screen takes of the frame buffer, as edges see it. Turn k, from 1, begins at the first edge e for
/// which e / (clocks a second) is not less than k / (turns a second).
class ScreenTiming {
 public:
  ScreenTiming(const isa::Program& program, const machines::Machine& machine);

  /// The bank that a turn takes in the clock that begins with that edge, which is not before the one asked for last.
  [[nodiscard]] std::optional<std::uint32_t> bank(Time now);

  /// Clocks in turns, up to the one that begins with that edge.
  [[nodiscard]] std::uint64_t clocks_until(Time end) const;

 private:
  [[nodiscard]] std::uint64_t turns_until(Time now) const;
  [[nodiscard]] Time begin_of(std::uint64_t turn) const;
  void go_to(std::uint64_t turn);

  std::uint64_t turns_a_picture_;
  std::uint64_t turns_a_second_;
  std::uint64_t clock_hz_;
  std::uint64_t turn_clocks_;
  std::uint64_t turn_bits_;
  std::uint64_t row_bits_;
  std::uint32_t banks_;

  // Of the turn that was asked for last.
  std::uint32_t bank_ = 0;
  Time end_ = 0;   ///< 0: it is none
  Time next_ = 0;  ///< the next one begins
};

}  // namespace csgsim::pixel_square
