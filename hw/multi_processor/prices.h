#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/isa/program.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/list_form.h"

/// Clocks of a node for an instruction of its list that depend only on the machine's parameters, not on the state of
/// the pixels.
namespace csgsim::multi_processor {

/// Number of bits of a command in a node's memory.
std::uint64_t written_bits(const isa::Command& command, const ListForm& form);

/// Clocks to unpack consecutive numbers of the given widths, packed from the start of a word, to separate words.
std::uint64_t unpacking_clocks(std::span<const std::uint8_t> widths, const Figures& figures);

/// Clocks of an instruction at a pixel, depending on how much of the instruction is executed there.
struct PixelCosts {
  std::uint64_t disabled = 0;    ///< E is 0 and the instruction has no effect
  std::uint64_t unselected = 0;  ///< E is 1 and the stored value is kept
  std::uint64_t full = 0;        ///< full execution, with no branch taken

  [[nodiscard]] constexpr std::uint64_t maximum() const { return std::max({disabled, unselected, full}); }
};

/// Clocks of an instruction at a pixel, without the surrounding loops and the work at the start of a row.
PixelCosts pixel_costs(const isa::Instruction& instruction, const Figures& figures);

struct InstructionCosts {
  PixelCosts at_pixel;
  std::uint64_t link = 0;   ///< clocks to append a call to a native program; 0 for interpreted lists
  std::uint64_t reach = 0;  ///< clocks to fetch the instruction from the list
  std::uint64_t sum = 0;    ///< clocks of its expression at the first pixel, and of its increments in x and y
  /// Clocks in addition to at_pixel: once per instruction, once per row, and once per pixel.
  std::uint64_t once = 0;
  std::uint64_t row = 0;
  std::uint64_t pixel = 0;

  /// Clocks of a node with `rows` rows and `pixels` pixels, without the clocks of at_pixel.
  [[nodiscard]] constexpr std::uint64_t overhead_clocks(std::uint64_t rows, std::uint64_t pixels) const {
    return once + rows * row + pixels * pixel;
  }
};

InstructionCosts instruction_costs(const isa::Instruction& instruction, const ListForm& form, const Figures& figures);

}  // namespace csgsim::multi_processor
