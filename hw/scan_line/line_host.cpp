#include "hw/scan_line/line_host.h"

namespace csgsim::scan_line {

LineHost::LineHost(sc_core::sc_module_name name, const Figures& figures)
    : systemc::ClockedModule(name), lines("lines", figures.chains), figures_(figures) {}

void LineHost::begin(const PictureLines& frame) {
  frame_ = frame;
  active_.begin(frame.extents);
  sorting_ = active_.primitives() * figures_.bucket_clocks;
  line_ = 0;
  counter_.begin();
  begin_line();
}

void LineHost::begin_line() {
  if (line_ == frame_.lines.size()) return;
  const isa::Segment& line = frame_.lines[line_];
  updating_ = active_.advance_to(line.region.y) * figures_.active_clocks;
  preparing_ = line.instructions.size() * figures_.instruction_clocks;
}

void LineHost::on_clock() {
  current_line_ = line_;
  counter_.edge(act());
}

LineActivity LineHost::act() {
  if (line_ == frame_.lines.size()) return LineActivity::done;
  if (sorting_ > 0) {
    --sorting_;
    return LineActivity::sorting;
  }
  if (updating_ > 0) {
    --updating_;
    return LineActivity::updating;
  }
  if (preparing_ > 0) {
    --preparing_;
    return LineActivity::preparing;
  }
  if (!lines[line_ % figures_.chains].nb_write(line_)) return LineActivity::waiting_for_link;
  ++line_;
  begin_line();
  return LineActivity::starting;
}

}  // namespace csgsim::scan_line
