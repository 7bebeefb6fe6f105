#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/isa/program.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/list_form.h"

/// Clocks of a node for an instruction of its list, which the figures alone decide: the same at whichever pixels.
namespace csgsim::multi_processor {

/// Bits of a command of a list.
std::uint64_t written_bits(const isa::Command& command, const ListForm& form);

/// Of numbers of so many bits that follow each other from the beginning of a word on, to get each into words of its
/// own.
std::uint64_t unpacking_clocks(std::span<const std::uint8_t> widths, const Figures& figures);

/// Of an instruction at a pixel, by how much of it is carried out there.
struct PixelPrices {
  std::uint64_t disabled = 0;  ///< where it has no effect, since E is 0
  std::uint64_t unchosen = 0;  ///< where E is 1 and it keeps what is there
  std::uint64_t whole = 0;     ///< if no branch is taken

  [[nodiscard]] constexpr std::uint64_t most() const { return std::max({disabled, unchosen, whole}); }
};

/// Without the loops around it and what begins a row.
PixelPrices pixel_prices(const isa::Instruction& instruction, const Figures& figures);

struct InstructionPrices {
  PixelPrices at_pixel;
  std::uint64_t link = 0;   ///< to make it a call of a native program; 0 where lists are interpreted
  std::uint64_t reach = 0;  ///< to come to it in the list
  std::uint64_t sum = 0;    ///< of its expression at the first pixel, and what it grows by across and down
  /// Besides what it takes at each pixel: once for the node's pixels, at each of their rows, at each of them.
  std::uint64_t once = 0;
  std::uint64_t row = 0;
  std::uint64_t pixel = 0;

  [[nodiscard]] constexpr std::uint64_t around(std::uint64_t rows, std::uint64_t pixels) const {
    return once + rows * row + pixels * pixel;
  }
};

InstructionPrices prices_of(const isa::Instruction& instruction, const ListForm& form, const Figures& figures);

}  // namespace csgsim::multi_processor
