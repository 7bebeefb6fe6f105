#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "tests/waves/vcd.h"

namespace csgsim::test {

/// A pixel's states in the reference after each instruction, with the clocks in which the instruction executes there,
/// computed without stepping.
class EngineState {
 public:
  /// Records memory and enable of the pixel in its segment. The pixel must belong to exactly one segment.
  EngineState(const isa::Program& program, const machines::Machine& machine, std::uint32_t x, std::uint32_t y);

  /// The field's value throughout the clock. Empty while the clearing or an instruction that writes the field executes
  /// and outside the executed instructions.
  [[nodiscard]] std::optional<std::uint64_t> field_at(isa::Field field, std::uint64_t clock) const;
  /// The enable bit throughout the clock, or empty as above.
  [[nodiscard]] std::optional<bool> enable_at(std::uint64_t clock) const;

  /// The instruction that executes at the pixel in that clock, numbered as in the whole Program; empty between
  /// instructions.
  [[nodiscard]] std::optional<std::uint64_t> instruction_at(std::uint64_t clock) const;

  [[nodiscard]] std::uint64_t first_clock() const;  ///< first clock after the clearing
  [[nodiscard]] std::uint64_t last_clock() const { return boundaries_.back().end; }

 private:
  struct Boundary {
    const isa::Instruction* instruction = nullptr;
    std::uint64_t number = 0;
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    std::vector<bool> memory;  ///< memory after the instruction
    bool enable = false;
  };

  /// The last boundary at which the clock has not begun; null if there is none, or if it is the last of all.
  [[nodiscard]] const Boundary* boundary_before(std::uint64_t clock) const;

  std::vector<Boundary> boundaries_;  ///< starts with the clearing
};

}  // namespace csgsim::test
