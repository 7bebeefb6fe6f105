#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "tests/waves/vcd.h"

namespace csgsim::test {

/// A pixel after each instruction, as the reference has it, with the clocks in which the instruction is carried out
/// there, which are worked out without stepping.
class EngineState {
 public:
  /// Memory and enable of the pixel in its segment, of which there is one.
  EngineState(const isa::Program& program, const machines::Machine& machine, std::uint32_t x, std::uint32_t y);

  /// What the field holds throughout the clock; none in the clocks in which an instruction that writes it, or the
  /// clearing, is carried out, and before them all and behind them all.
  [[nodiscard]] std::optional<std::uint64_t> field_at(isa::Field field, std::uint64_t clock) const;
  /// The same of the enable bit.
  [[nodiscard]] std::optional<bool> enable_at(std::uint64_t clock) const;

  /// The instruction that is carried out at the pixel in that clock, numbered as in the whole Program; none between
  /// instructions.
  [[nodiscard]] std::optional<std::uint64_t> instruction_at(std::uint64_t clock) const;

  [[nodiscard]] std::uint64_t first_clock() const;  ///< after the clearing
  [[nodiscard]] std::uint64_t last_clock() const { return boundaries_.back().end; }

 private:
  struct Boundary {
    const isa::Instruction* instruction = nullptr;
    std::uint64_t number = 0;
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    std::vector<bool> memory;  ///< after it
    bool enable = false;
  };

  /// The last that is over when the clock begins; null if there is none, or it is the last of all.
  [[nodiscard]] const Boundary* before(std::uint64_t clock) const;

  std::vector<Boundary> boundaries_;  ///< the first is the clearing
};

}  // namespace csgsim::test
