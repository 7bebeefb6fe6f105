#include "hw/pixel_square/words.h"

namespace csgsim::pixel_square {

std::ostream& operator<<(std::ostream& stream, const ModelWord& /*word*/) { return stream << "model"; }

std::ostream& operator<<(std::ostream& stream, const InstructionWord& word) {
  stream << word.square.segment << ' ';
  return stream << (word.instruction == nullptr ? "end" : isa::info(word.instruction->opcode).name);
}

std::ostream& operator<<(std::ostream& stream, const ClearWord& word) {
  return stream << "clear " << word.region.x << ',' << word.region.y;
}

std::ostream& operator<<(std::ostream& stream, const ColourWord& word) {
  return stream << word.region.x << ',' << word.region.y << " bit " << word.first;
}

}  // namespace csgsim::pixel_square
