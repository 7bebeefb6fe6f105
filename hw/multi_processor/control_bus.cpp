#include "hw/multi_processor/control_bus.h"

#include <algorithm>

namespace csgsim::multi_processor {

ControlBus::ControlBus(sc_core::sc_module_name name, const machines::Machine& machine, std::size_t masters)
    : sc_core::sc_module(name), requests("requests", masters), time_(machine), link_(machine.link), served_(masters) {
  SC_HAS_PROCESS(ControlBus);
  SC_METHOD(on_request);
  dont_initialize();
  std::for_each(requests.begin(), requests.end(), [&](sc_core::sc_in<BusRequest>& request) { sensitive << request; });
  SC_METHOD(on_grant);
  dont_initialize();
  sensitive << granted_;
  SC_METHOD(on_word);
  dont_initialize();
  sensitive << arrived_;
}

void ControlBus::begin() { activities_.begin(BusActivity::idle, time_.now()); }

void ControlBus::on_request() {
  if (moving_) return;
  if (master_) {
    if (is_requesting(*master_)) transfer();
    return;
  }
  for (std::uint32_t master = 0; master < requests.size(); ++master) {
    if (is_requesting(master)) return start(master);
  }
}

void ControlBus::start(std::uint32_t master) {
  master_ = master;
  moving_ = true;
  activities_.change(BusActivity::granting, time_.now());
  granted_.notify(time_.of(link_.latency));
}

void ControlBus::on_grant() { transfer(); }

void ControlBus::transfer() {
  moving_ = true;
  activities_.change(BusActivity::busy, time_.now());
  arrived_.notify(time_.of(link_.word_clocks));
}

void ControlBus::on_word() {
  const std::uint32_t master = *master_;
  const BusRequest& sent = requests[master].read();
  moving_ = false;
  served_[master] = sent.number;
  if (sent.last) master_.reset();
  activities_.change(BusActivity::idle, time_.now());
  lines.write({++words_, master, sent});
  // Requests made while the bus was held are not repeated, so they are looked for here.
  if (!master_) on_request();
}

}  // namespace csgsim::multi_processor
