#pragma once

#include <cstdint>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

/// Analytic model of the turns in which the screen reads the nodes' memories.
namespace csgsim::multi_processor {

/// Computes when the nodes, which stall during turns, finish their work. Clocks are counted from the frame's first
/// clock, and turns from 1: turn k begins with the first clock that starts at least k / (turns per second) after the
/// start of the frame.
class Refresh {
 public:
  /// Turns for the picture of the node with the most pixels.
  Refresh(const isa::FrameHeader& header, const machines::Machine& machine);

  [[nodiscard]] bool takes_turns() const { return turns_per_second_ > 0; }
  [[nodiscard]] std::uint64_t turns_per_second() const { return turns_per_second_; }

  /// Clock in which a node finishes `work_clocks` clocks of work that start at clock `begin_clock`; `begin_clock` if
  /// `work_clocks` is 0.
  [[nodiscard]] std::uint64_t end_clock(std::uint64_t begin_clock, std::uint64_t work_clocks) const;

 private:
  [[nodiscard]] std::uint64_t free_clocks_until(std::uint64_t clock) const;

  std::uint64_t turns_per_second_ = 0;
  std::uint64_t clock_hz_;
  std::uint64_t turn_clocks_;
};

/// Throws InputError if the screen occupies every clock of the memories.
void check_refresh(const isa::FrameHeader& header, const machines::Machine& machine);

}  // namespace csgsim::multi_processor
