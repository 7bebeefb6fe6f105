#include "hw/scan_line/packet_signals.h"

namespace csgsim::scan_line {

std::ostream& operator<<(std::ostream& stream, const PacketWord& word) {
  switch (word.kind) {
    case WordKind::none: return stream << '-';
    case WordKind::clear: return stream << "clear";
    case WordKind::instruction:
      return stream << isa::name_of(word.instruction.opcode) << " beat " << word.number << " a=" << word.a
                    << " f=" << word.f;
    case WordKind::mark: return stream << "mark";
  }
  return stream;
}

std::ostream& operator<<(std::ostream& stream, const RefreshPixel& pixel) {
  return pixel.valid ? stream << pixel.colour : stream << '-';
}

std::ostream& operator<<(std::ostream& stream, const EntryAccount& account) {
  return stream << account.clocks << " clocks";
}

void sc_trace(sc_core::sc_trace_file* file, const PacketWord& word, const std::string& name) {
  sc_core::sc_trace(file, reinterpret_cast<const unsigned char&>(word.kind), name + ".kind");
  sc_core::sc_trace(file, reinterpret_cast<const unsigned char&>(word.instruction.opcode), name + ".opcode");
  sc_core::sc_trace(file, word.number, name + ".number");
  sc_core::sc_trace(file, word.a, name + ".a");
  sc_core::sc_trace(file, word.f, name + ".f");
  sc_core::sc_trace(file, word.segment, name + ".segment");
  sc_core::sc_trace(file, word.index, name + ".index");
}

void sc_trace(sc_core::sc_trace_file* file, const RefreshPixel& pixel, const std::string& name) {
  sc_core::sc_trace(file, pixel.valid, name + ".valid");
  sc_core::sc_trace(file, pixel.colour, name + ".colour");
}

}  // namespace csgsim::scan_line
