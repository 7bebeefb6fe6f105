#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "hw/isa/program.h"

/// What travels through the FIFOs between the modules, one word a clock.
namespace csgsim::pixel_square {

/// Host to divider: a primitive or a half-space of the model.
struct ModelWord {};

/// The address that goes with the words of a square.
struct Square {
  std::uint32_t segment = 0;  ///< of the Program
  isa::Region region;
};

/// Divider to renderer: an instruction, or the end of the square.
struct InstructionWord {
  Square square;
  const isa::Instruction* instruction = nullptr;  ///< of the Program; null at the end of the square
};

/// Divider to frame buffer: a square that nothing touches.
struct ClearWord {
  isa::Region region;
};

/// Renderer to frame buffer: some of a square's colour bits. Colours follow each other in row order, the least
/// significant bit of each first.
struct ColourWord {
  isa::Region region;
  std::uint64_t first = 0;          ///< of the square's colour bits
  std::uint32_t count = 0;          ///< bits in this word
  bool last = false;                ///< word of the square
  std::vector<std::uint64_t> bits;  ///< 64 a word
};

std::ostream& operator<<(std::ostream& stream, const ModelWord& word);
std::ostream& operator<<(std::ostream& stream, const InstructionWord& word);
std::ostream& operator<<(std::ostream& stream, const ClearWord& word);
std::ostream& operator<<(std::ostream& stream, const ColourWord& word);

}  // namespace csgsim::pixel_square
