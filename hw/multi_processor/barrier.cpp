#include "hw/multi_processor/barrier.h"

#include <algorithm>

#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

Barrier::Barrier(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      arrivals("arrivals", std::size_t{machine.array.width} * machine.array.height),
      time_(machine),
      clocks_(machines::kind_figures<Figures>(machine).barrier_clocks) {
  SC_HAS_PROCESS(Barrier);
  SC_METHOD(on_arrival);
  dont_initialize();
  std::for_each(arrivals.begin(), arrivals.end(), [&](sc_core::sc_in<std::uint64_t>& node) { sensitive << node; });
  SC_METHOD(on_release);
  dont_initialize();
  sensitive << release_;
}

void Barrier::on_arrival() {
  const bool all =
      std::all_of(arrivals.begin(), arrivals.end(), [&](const auto& node) { return node.read() > rounds_; });
  if (!all) return;
  gathered.write(++rounds_);
  release_.notify(time_.of(clocks_));
}

}  // namespace csgsim::multi_processor
