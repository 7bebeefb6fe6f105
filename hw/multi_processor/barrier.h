#pragma once

#include <cstddef>
#include <cstdint>
#include <systemc>

#include "hw/machines/machine.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// A common line that releases all nodes `barrier.clocks` clocks after the last of them has arrived.
class Barrier final : public sc_core::sc_module {
 public:
  sc_core::sc_vector<sc_core::sc_in<std::uint64_t>> arrivals;  ///< number of arrivals of each node
  sc_core::sc_out<std::uint64_t> gathered{"gathered"};         ///< number of times that all nodes have arrived
  sc_core::sc_out<std::uint64_t> released{"released"};         ///< number of times that all nodes were released

  Barrier(sc_core::sc_module_name name, const machines::Machine& machine);

 private:
  void on_arrival();
  void on_release() { released.write(rounds_); }

  TimeBase time_;
  const std::uint64_t clocks_;
  std::uint64_t rounds_ = 0;
  sc_core::sc_event release_{"release"};
};

}  // namespace csgsim::multi_processor
