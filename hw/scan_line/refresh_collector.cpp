#include "hw/scan_line/refresh_collector.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace csgsim::scan_line {

RefreshCollector::RefreshCollector(sc_core::sc_module_name name, std::uint32_t chains)
    : systemc::ClockedModule(name), refresh("refresh", chains), entering("entering", chains) {}

void RefreshCollector::begin(const PictureLines& frame) {
  PendingFrame& next = pending_.emplace_back();
  next.pixels = frame.pixels();
  next.missing_lines = frame.lines.size();
  next.line_of_chain.resize(refresh.size());
  std::iota(next.line_of_chain.begin(), next.line_of_chain.end(), std::size_t{0});
  next.shown.chains.resize(refresh.size());
  next.shown.lines.resize(frame.lines.size());
  for (std::vector<std::uint32_t>& line : next.shown.lines) line.reserve(next.pixels);
}

ShownFrame RefreshCollector::pop_frame() {
  ShownFrame shown = std::move(complete_.front());
  complete_.pop_front();
  return shown;
}

std::size_t RefreshCollector::line_of(std::size_t chain) const {
  return pending_.empty() ? chain : pending_.front().line_of_chain[chain];
}

void RefreshCollector::on_clock() {
  for (PendingFrame& frame : pending_) count_clock(frame, &frame == &pending_.back());
  for (std::size_t chain = 0; chain < refresh.size(); ++chain) poll(chain);
  while (!pending_.empty() && pending_.front().missing_lines == 0) {
    pending_.front().shown.clocks = pending_.front().periods.count();
    complete_.push_back(std::move(pending_.front().shown));
    pending_.pop_front();
    frames.write(++frames_done_);
  }
}

/// The signal `entering` refers only to the newest frame.
void RefreshCollector::count_clock(PendingFrame& frame, bool is_last) {
  frame.periods.edge();
  if (is_last) {
    frame.entering_marks = any_entering();
    if (frame.periods.count() > 0 && !frame.entering_marks) ++frame.shown.drain_clocks;
  } else if (std::exchange(frame.entering_marks, false)) {
    return;
  } else {
    ++frame.shown.drain_clocks;
  }
}

/// A pixel belongs to the oldest frame of which that chain still has lines to show.
void RefreshCollector::poll(std::size_t chain) {
  const RefreshPixel& pixel = refresh[chain].read();
  bool is_taken = !pixel.valid;
  for (PendingFrame& frame : pending_) {
    if (frame.periods.count() == 0) continue;
    const bool waits = frame.line_of_chain[chain] < frame.shown.lines.size();
    const bool shows = waits && !is_taken;
    frame.shown.chains[chain].add(shows   ? LineActivity::showing
                                  : waits ? LineActivity::waiting_for_line
                                          : LineActivity::done);
    if (shows) collect(frame, chain, pixel.colour);
    is_taken = is_taken || shows;
  }
}

void RefreshCollector::collect(PendingFrame& frame, std::size_t chain, std::uint32_t colour) {
  std::size_t& number = frame.line_of_chain[chain];
  std::vector<std::uint32_t>& line = frame.shown.lines[number];
  line.push_back(colour);
  if (line.size() < frame.pixels) return;
  number += frame.line_of_chain.size();
  --frame.missing_lines;
  if (frame.periods.count() > frame.last_pixel) frame.shown.last_chain = chain;
  frame.last_pixel = frame.periods.count();
}

bool RefreshCollector::any_entering() const {
  return std::any_of(entering.begin(), entering.end(), [](const auto& one) { return one.read(); });
}

}  // namespace csgsim::scan_line
