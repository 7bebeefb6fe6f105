#include "hw/scan_line/cell_chain.h"

#include <algorithm>
#include <stdexcept>

#include "hw/scan_line/snapshot_view.h"

namespace csgsim::scan_line {

CellChain::CellChain(sc_core::sc_module_name name, const isa::ArrayShape& cells, const CellShape& shape)
    : systemc::ClockedModule(name), chain_(cells.width, cells.memory_bits, shape) {}

void CellChain::clear(std::uint32_t line_pixels) {
  chain_.begin(line_pixels);
  frames_.clear();
}

void CellChain::begin(std::size_t line_count) { frames_.push_back({.lines_left = line_count}); }

CellCounts CellChain::pop_counts() {
  const CellCounts counts = frames_.front().counts;
  frames_.pop_front();
  return counts;
}

void CellChain::on_clock() {
  for (Frame& frame : frames_) frame.periods.edge();
  chain_.step(entry.read());
  refresh.write(chain_.refresh());
  const Departure& departure = chain_.departure();
  if (departure.kind == PacketKind::none) return;
  Frame& frame = leaving();
  if (frame.counts.fill_clocks == 0) frame.counts.fill_clocks = frame.periods.count();
  frame.counts.busy_cells += departure.busy_cells;
  if (departure.kind != PacketKind::clear) retire(departure);
  if (departure.kind == PacketKind::mark) --frame.lines_left;
}

/// The first frame with lines left; the oldest packet in the cells belongs to it.
CellChain::Frame& CellChain::leaving() {
  const auto found =
      std::find_if(frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.lines_left > 0; });
  if (found == frames_.end()) throw std::logic_error("a packet that belongs to no frame left the cells");
  return *found;
}

void CellChain::retire(const Departure& departure) {
  EntryAccount account;
  if (!accounts.nb_read(account)) SC_REPORT_FATAL("csgsim", "a packet without an account left the chain");
  const SnapshotView line(departure.snapshot);
  if (departure.kind == PacketKind::mark) return retirement->after_segment(departure.segment, line);
  retirement->after_instruction({.segment = departure.segment,
                                 .index = departure.index,
                                 .clocks = account.clocks,
                                 .enabled_pixels = departure.enabled_pixels},
                                line);
}

}  // namespace csgsim::scan_line
