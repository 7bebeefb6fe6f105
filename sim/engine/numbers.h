// Instruction numbers and places in a Program.
// Used by sim/engine, sim/debug, sim/observe, sim/report and sim/viewer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "hw/isa/instruction_numbers.h"
#include "hw/isa/program.h"

namespace csgsim::engine {

/// An instruction boundary of a run: before an instruction, or at the end of its segment.
struct Place {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< index of the segment's next instruction; equal to their number at the end

  constexpr bool operator==(const Place&) const = default;
};

/// Instruction numbers of a whole Program (hw/isa/instruction_numbers.h), and their places.
class Numbers {
 public:
  explicit Numbers(const isa::Program& program) : firsts_(isa::first_instruction_numbers(program)) {}

  /// Number of instructions of the Program.
  [[nodiscard]] std::uint64_t count() const { return firsts_.back(); }

  /// Number of the instruction there; at a segment's end, of the first one after it.
  [[nodiscard]] std::uint64_t of(Place place) const { return firsts_[place.segment] + place.index; }

  /// Number of the segment's first instruction.
  [[nodiscard]] std::uint64_t first(std::uint32_t segment) const { return firsts_[segment]; }

  /// Place of the instruction with that number, which is below count().
  [[nodiscard]] Place place(std::uint64_t number) const {
    const auto after = std::upper_bound(firsts_.begin(), firsts_.end(), number);
    const auto segment = static_cast<std::uint32_t>(after - firsts_.begin() - 1);
    return {segment, static_cast<std::uint32_t>(number - firsts_[segment])};
  }

 private:
  std::vector<std::uint64_t> firsts_;  ///< first number of each segment, and the count
};

}  // namespace csgsim::engine
