#pragma once

#include <cstddef>
#include <cstdint>
#include <systemc>

#include "hw/machines/machine.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// A common line that lets all nodes go on `barrier.clocks` clocks after the last of them has come.
class Barrier final : public sc_core::sc_module {
 public:
  sc_core::sc_vector<sc_core::sc_in<std::uint64_t>> arrivals;  ///< how often each node has come
  sc_core::sc_out<std::uint64_t> gathered{"gathered"};         ///< how often all have
  sc_core::sc_out<std::uint64_t> released{"released"};         ///< how often all may go on

  Barrier(sc_core::sc_module_name name, const machines::Machine& machine);

 private:
  void on_arrival();
  void on_release() { released.write(times_); }

  TimeBase time_;
  const std::uint64_t clocks_;
  std::uint64_t times_ = 0;
  sc_core::sc_event release_{"release"};
};

}  // namespace csgsim::multi_processor
