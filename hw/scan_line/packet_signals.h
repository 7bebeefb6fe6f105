#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <systemc>

#include "hw/scan_line/packet.h"
#include "hw/systemc/wire.h"

/// What SystemC asks of the values on the wires between the modules.
namespace csgsim::scan_line {

/// What a packet queue counted for one packet or mark.
struct EntryAccount {
  std::uint64_t clocks = 0;  ///< in which its words were entering
};

// Which nobody calls (hw/systemc/wire.h).
template <systemc::OneOf<Beat, RefreshPixel, EntryAccount> Value>
std::ostream& operator<<(std::ostream& stream, const Value& /*value*/) {
  return stream;
}
template <systemc::OneOf<Beat, RefreshPixel> Value>
void sc_trace(sc_core::sc_trace_file* /*file*/, const Value& /*value*/, const std::string& /*name*/) {}

}  // namespace csgsim::scan_line
