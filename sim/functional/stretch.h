// A sequence of instructions that each tile can execute without interruption.
// Used by tiles and the functional run.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"
#include "sim/engine/engine.h"

namespace csgsim::functional {

/// Instructions that are executed one tile after the other.
class Stretch {
 public:
  /// Holds the first of `instructions` (at least one), up to and including the first one after which others may be
  /// skipped or an observer reads more of the pixels than their enable bits. The number is limited, so that progress is
  /// shown.
  Stretch(std::span<const isa::Instruction> instructions, std::span<engine::Observer* const> observers);

  [[nodiscard]] std::span<const isa::Instruction> instructions() const { return instructions_; }
  [[nodiscard]] std::size_t size() const { return instructions_.size(); }

  /// Index of the first instruction from `index` on that acts where no pixel is enabled; size() if there is none.
  [[nodiscard]] std::size_t first_acting_from(std::size_t index) const { return first_acting_[index]; }

  /// Whether an observer reads the enable bits, and nothing else, after that instruction.
  [[nodiscard]] bool is_observed(std::size_t index) const { return observed_[index] != 0; }
  /// Passes the enable bits of a part of the picture after that instruction to those observers.
  void notify_observers(std::size_t instruction_index, const isa::Region& part,
                        std::span<const std::uint64_t> enable_words) const;

 private:
  void find_end(std::span<const isa::Instruction> instructions);
  void find_first_acting();

  std::span<const isa::Instruction> instructions_;
  std::span<engine::Observer* const> observers_;
  std::vector<std::uint32_t> first_acting_;
  std::vector<std::uint8_t> observed_;
};

}  // namespace csgsim::functional
