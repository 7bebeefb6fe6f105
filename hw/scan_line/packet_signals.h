#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <systemc>

#include "hw/scan_line/packet.h"

/// What SystemC asks of the values on the wires between the modules.
namespace csgsim::scan_line {

/// What a packet queue counted for one packet or mark.
struct EntryAccount {
  std::uint64_t clocks = 0;  ///< in which its words were entering
};

std::ostream& operator<<(std::ostream& stream, const PacketWord& word);
std::ostream& operator<<(std::ostream& stream, const RefreshPixel& pixel);
std::ostream& operator<<(std::ostream& stream, const EntryAccount& account);

void sc_trace(sc_core::sc_trace_file* file, const PacketWord& word, const std::string& name);
void sc_trace(sc_core::sc_trace_file* file, const RefreshPixel& pixel, const std::string& name);

}  // namespace csgsim::scan_line
