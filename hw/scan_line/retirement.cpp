#include "hw/scan_line/retirement.h"

namespace csgsim::scan_line {

Retirement::Retirement(sc_core::sc_module_name name) : sc_core::sc_module(name) {
  SC_HAS_PROCESS(Retirement);
  SC_METHOD(retire);
  dont_initialize();
  sensitive << departed;
}

void Retirement::retire() {
  EntryAccount account;
  if (!accounts.nb_read(account)) SC_REPORT_FATAL("csgsim", "a packet left the chain that nobody accounted for");
  guard_.run([&] { tell(exit->departure(), account); });
}

void Retirement::tell(const Departure& departure, const EntryAccount& account) {
  if (departure.kind == WordKind::mark) return listener_->after_line(departure.segment, *departure.snapshot);
  listener_->after_instruction({.segment = departure.segment,
                                .index = departure.index,
                                .clocks = account.clocks,
                                .enabled_pixels = departure.enabled_pixels},
                               departure.snapshot);
}

}  // namespace csgsim::scan_line
