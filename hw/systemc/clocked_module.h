// Base class of clocked modules.
// Used by hw/link, hw/pixel_planes, hw/pixel_square and hw/scan_line.
#pragma once

#include <systemc>

namespace csgsim::systemc {

/// Base class of modules that act at each rising edge of the clock.
class ClockedModule : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};

 protected:
  explicit ClockedModule(sc_core::sc_module_name name) : sc_core::sc_module(name) {
    SC_HAS_PROCESS(ClockedModule);
    SC_METHOD(on_clock);
    dont_initialize();
    sensitive << clock.pos();
  }

 private:
  virtual void on_clock() = 0;
};

}  // namespace csgsim::systemc
