#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"
#include "sim/engine/engine.h"

namespace csgsim::functional {

/// Instructions that tiles carry out one tile after the other.
class Stretch {
 public:
  /// The first of `instructions`, one at least: until one, inclusive, after which some may be skipped, or an observer
  /// looks at more of the pixels than which are enabled; few enough to show progress.
  Stretch(std::span<const isa::Instruction> instructions, std::span<engine::Observer* const> observers);

  [[nodiscard]] std::span<const isa::Instruction> instructions() const { return instructions_; }
  [[nodiscard]] std::size_t size() const { return instructions_.size(); }

  /// The first from this one on that does anything where no pixel is enabled; size() if none does.
  [[nodiscard]] std::size_t wakes_from(std::size_t index) const { return wakes_[index]; }

  /// Does an observer look at the enable bits after that instruction, and at nothing else?
  [[nodiscard]] bool is_looked_at(std::size_t index) const { return looked_at_[index] != 0; }
  /// Shows those observers the enable bits of a part of the picture after that instruction.
  void show(std::size_t index, const isa::Region& part, std::span<const std::uint64_t> words) const;

 private:
  void find_end(std::span<const isa::Instruction> instructions);
  void find_wakes();

  std::span<const isa::Instruction> instructions_;
  std::span<engine::Observer* const> observers_;
  std::vector<std::uint32_t> wakes_;
  std::vector<std::uint8_t> looked_at_;
};

}  // namespace csgsim::functional
