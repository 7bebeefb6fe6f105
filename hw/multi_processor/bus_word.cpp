#include "hw/multi_processor/bus_word.h"

namespace csgsim::multi_processor {

std::ostream& operator<<(std::ostream& stream, const BusRequest& request) {
  return stream << "word " << request.number << (request.last ? ", the last" : "");
}

std::ostream& operator<<(std::ostream& stream, const BusLines& lines) {
  return stream << lines.number << " from " << lines.master << ": " << lines.sent;
}

std::ostream& operator<<(std::ostream& stream, const HostWord& word) { return stream << "word " << word.number; }

void sc_trace(sc_core::sc_trace_file* file, const BusRequest& request, const std::string& name) {
  sc_core::sc_trace(file, request.number, name + ".number");
  sc_core::sc_trace(file, request.last, name + ".last");
}

void sc_trace(sc_core::sc_trace_file* file, const BusLines& lines, const std::string& name) {
  sc_core::sc_trace(file, lines.number, name + ".number");
  sc_core::sc_trace(file, lines.master, name + ".master");
  sc_trace(file, lines.sent, name + ".sent");
}

void sc_trace(sc_core::sc_trace_file* file, const HostWord& word, const std::string& name) {
  sc_core::sc_trace(file, word.number, name + ".number");
}

}  // namespace csgsim::multi_processor
