#include "hw/systemc/clock.h"

#include <stdexcept>

namespace csgsim::systemc {

Clock::Clock(sc_core::sc_module_name name, const sc_core::sc_time& period) : sc_core::sc_module(name), period_(period) {
  SC_HAS_PROCESS(Clock);
  SC_METHOD(tick);
  sensitive << edge_;
}

const sc_core::sc_event& Clock::negedge_event() const {
  throw std::logic_error("a clock with rising edges only has no falling edges");
}

void Clock::tick() { edge_.notify(period_); }

}  // namespace csgsim::systemc
