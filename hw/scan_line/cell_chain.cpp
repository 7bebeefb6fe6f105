#include "hw/scan_line/cell_chain.h"

#include "hw/scan_line/snapshot_view.h"

namespace csgsim::scan_line {

CellChain::CellChain(sc_core::sc_module_name name, const isa::ArrayShape& cells, const CellShape& shape)
    : systemc::ClockedModule(name), chain_(cells.width, cells.memory_bits, shape) {}

void CellChain::begin(std::uint32_t pixels) {
  chain_.begin(pixels);
  periods_.begin();
  fill_clocks_ = 0;
}

void CellChain::on_clock() {
  periods_.edge();
  chain_.step(entry.read());
  refresh.write(chain_.refresh());
  if (chain_.departure().kind == WordKind::none) return;
  if (fill_clocks_ == 0) fill_clocks_ = periods_.count();
  if (chain_.departure().kind != WordKind::clear) retire(chain_.departure());
}

void CellChain::retire(const Departure& departure) {
  EntryAccount account;
  if (!accounts.nb_read(account)) SC_REPORT_FATAL("csgsim", "a packet left the chain that nobody accounted for");
  const SnapshotView line(departure.snapshot);
  if (departure.kind == WordKind::mark) return retirement->after_segment(departure.segment, line);
  retirement->after_instruction({.segment = departure.segment,
                                 .index = departure.index,
                                 .clocks = account.clocks,
                                 .enabled_pixels = departure.enabled_pixels},
                                line);
}

}  // namespace csgsim::scan_line
