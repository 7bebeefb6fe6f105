#pragma once

#include <cstdint>
#include <systemc>

#include "hw/scan_line/cell_chain.h"
#include "hw/scan_line/frame.h"
#include "hw/scan_line/words.h"
#include "hw/systemc/listener_guard.h"

namespace csgsim::scan_line {

/// Tells the listener of each packet and mark when it has left the last cell of its line. Takes no clock.
class Retirement final : public sc_core::sc_module {
 public:
  sc_core::sc_in<std::uint64_t> departed{"departed"};
  sc_core::sc_fifo_in<EntryAccount> accounts{"accounts"};
  sc_core::sc_port<ChainExit> exit{"exit"};

  explicit Retirement(sc_core::sc_module_name name);

  void begin(RunListener& listener) { listener_ = &listener; }

  /// Throws what the listener threw, if it did: the machine ran to its end without it.
  void rethrow() { guard_.rethrow(); }

 private:
  void retire();
  void tell(const Departure& departure, const EntryAccount& account);

  RunListener* listener_ = nullptr;
  kernel::ListenerGuard guard_;
};

}  // namespace csgsim::scan_line
