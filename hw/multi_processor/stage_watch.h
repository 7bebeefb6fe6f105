#pragma once

#include <cstdint>
#include <systemc>

#include "hw/machines/machine.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// Counts the clocks of the stages that all nodes go through together: second pruning, sharing, rendering and barriers.
/// Not a hardware unit.
class StageWatch final : public sc_core::sc_module {
 public:
  sc_core::sc_in<BusLines> bus{"bus"};
  sc_core::sc_in<std::uint64_t> gathered{"gathered"};
  sc_core::sc_in<std::uint64_t> released{"released"};

  StageWatch(sc_core::sc_module_name name, const machines::Machine& machine);

  void begin() { stages_ = {}; }

  /// Stores the clocks of second pruning, sharing, rendering and barriers; the display processor counts the others.
  void store_stages(StageClocks& stages) const {
    stages.second_pruning = stages_.second_pruning;
    stages.sharing = stages_.sharing;
    stages.rendering = stages_.rendering;
    stages.barriers = stages_.barriers;
  }

 private:
  void on_word();
  void on_gathered();
  void on_released();
  std::uint64_t passed();

  TimeBase time_;
  std::uint64_t since_ = 0;
  bool prunes_ = false;  ///< the nodes prune next: data of a segment has arrived
  StageClocks stages_;
};

}  // namespace csgsim::multi_processor
