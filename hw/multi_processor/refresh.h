#pragma once

#include <cstdint>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

/// What a screen takes of the nodes' memories, worked out.
namespace csgsim::multi_processor {

/// The nodes stand still in the clocks of a turn. Clocks are counted from the frame's first, and so are turns, from 1:
/// turn k begins with the first clock that begins no sooner than k / (turns a second) after the frame.
class Refresh {
 public:
  /// Of what a node, of those with most pixels, has of the picture.
  Refresh(const isa::FrameHeader& header, const machines::Machine& machine);

  [[nodiscard]] bool takes_turns() const { return turns_a_second_ > 0; }
  [[nodiscard]] std::uint64_t turns_a_second() const { return turns_a_second_; }

  /// When a node that begins at a clock with what takes it so many is done; that clock if it takes none.
  [[nodiscard]] std::uint64_t end_of(std::uint64_t begin, std::uint64_t clocks) const;

 private:
  [[nodiscard]] std::uint64_t free_until(std::uint64_t clock) const;

  std::uint64_t turns_a_second_ = 0;
  std::uint64_t clock_hz_;
  std::uint64_t turn_clocks_;
};

/// Throws InputError if the screen takes every clock of the memories, or more.
void check_refresh(const isa::FrameHeader& header, const machines::Machine& machine);

}  // namespace csgsim::multi_processor
