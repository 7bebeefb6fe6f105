#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <systemc>

#include "hw/scan_line/packet.h"
#include "hw/systemc/wire.h"

/// Values of the signals between the modules, with the operators that SystemC requires.
namespace csgsim::scan_line {

/// Counts of a packet queue for one packet or mark.
struct EntryAccount {
  std::uint64_t clocks = 0;  ///< clocks in which the packet's words were entering
};

// Required by sc_signal; never called (hw/systemc/wire.h).
template <systemc::OneOf<Beat, RefreshPixel, EntryAccount> Value>
std::ostream& operator<<(std::ostream& stream, const Value& /*value*/) {
  return stream;
}
template <systemc::OneOf<Beat, RefreshPixel> Value>
void sc_trace(sc_core::sc_trace_file* /*file*/, const Value& /*value*/, const std::string& /*name*/) {}

}  // namespace csgsim::scan_line
