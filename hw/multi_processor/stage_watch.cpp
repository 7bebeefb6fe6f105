#include "hw/multi_processor/stage_watch.h"

#include <utility>

namespace csgsim::multi_processor {

StageWatch::StageWatch(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name), time_(machine) {
  SC_HAS_PROCESS(StageWatch);
  SC_METHOD(on_word);
  dont_initialize();
  sensitive << bus;
  SC_METHOD(on_gathered);
  dont_initialize();
  sensitive << gathered;
  SC_METHOD(on_released);
  dont_initialize();
  sensitive << released;
}

std::uint64_t StageWatch::passed() {
  const std::uint64_t now = time_.now();
  return now - std::exchange(since_, now);
}

void StageWatch::on_word() {
  const BusLines& lines = bus.read();
  if (is_segment_record(lines.sent.kind)) prunes_ = true;
  if (!lines.sent.last) return;
  const std::uint64_t clocks = passed();
  if (is_halfspace_read(lines.sent.kind)) {
    stages_.second_pruning += clocks;
  } else if (lines.master != display_master) {
    stages_.sharing += clocks;
  }
}

void StageWatch::on_gathered() {
  (std::exchange(prunes_, false) ? stages_.second_pruning : stages_.rendering) += passed();
}

void StageWatch::on_released() { stages_.barriers += passed(); }

}  // namespace csgsim::multi_processor
