#include "hw/pixel_planes/control_word.h"

namespace csgsim::pixel_planes {

std::ostream& operator<<(std::ostream& stream, const RootWord& word) {
  return stream << "bit " << word.bits.token.bit << " a=" << word.bits.a << " b=" << word.bits.b
                << " c=" << word.bits.c;
}

std::ostream& operator<<(std::ostream& stream, const TreeWord& word) {
  return stream << "bit " << word.bit.token.bit << " of " << word.bit.a << "x + " << word.bit.b << "y + " << word.bit.c;
}

std::ostream& operator<<(std::ostream& stream, const ControlWord& word) {
  return stream << word.ordinal << ' ' << (word.clears ? "clear" : array::info(word.step.function).name);
}

std::ostream& operator<<(std::ostream& stream, const Answer& answer) {
  return answer.valid ? stream << answer.any_enabled : stream << '-';
}

std::ostream& operator<<(std::ostream& stream, const RefreshStep& step) {
  return stream << "bit " << step.address << " of row " << step.row;
}

std::ostream& operator<<(std::ostream& stream, const FinishedPicture& picture) {
  return stream << picture.colour.width << " bits from " << picture.colour.base;
}

std::ostream& operator<<(std::ostream& stream, const Account& account) { return stream << account.clocks << " clocks"; }

void sc_trace(sc_core::sc_trace_file* file, const RootWord& word, const std::string& name) {
  sc_core::sc_trace(file, word.bits.a, name + ".a");
  sc_core::sc_trace(file, word.bits.b, name + ".b");
  sc_core::sc_trace(file, word.bits.c, name + ".c");
  sc_core::sc_trace(file, word.bits.token.bit, name + ".bit");
}

void sc_trace(sc_core::sc_trace_file* file, const TreeWord& word, const std::string& name) {
  sc_core::sc_trace(file, word.bit.a, name + ".a");
  sc_core::sc_trace(file, word.bit.b, name + ".b");
  sc_core::sc_trace(file, word.bit.c, name + ".c");
  sc_core::sc_trace(file, word.bit.token.bit, name + ".bit");
}

void sc_trace(sc_core::sc_trace_file* file, const ControlWord& word, const std::string& name) {
  sc_core::sc_trace(file, reinterpret_cast<const unsigned char&>(word.step.function), name + ".function");
  sc_core::sc_trace(file, word.step.x, name + ".read_x");
  sc_core::sc_trace(file, word.step.y, name + ".read_y");
  sc_core::sc_trace(file, word.step.write, name + ".write");
  sc_core::sc_trace(file, word.step.bits, name + ".bits");
  sc_core::sc_trace(file, word.step.constant, name + ".constant");
  sc_core::sc_trace(file, word.clears, name + ".clears");
  sc_core::sc_trace(file, word.clear.address, name + ".clear_address");
  sc_core::sc_trace(file, word.refreshes, name + ".refreshes");
  sc_core::sc_trace(file, word.last, name + ".last");
  sc_core::sc_trace(file, word.ordinal, name + ".instruction");
}

void sc_trace(sc_core::sc_trace_file* file, const Answer& answer, const std::string& name) {
  sc_core::sc_trace(file, answer.valid, name + ".valid");
  sc_core::sc_trace(file, answer.any_enabled, name + ".any_enabled");
}

}  // namespace csgsim::pixel_planes
