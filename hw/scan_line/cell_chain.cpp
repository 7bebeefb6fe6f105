#include "hw/scan_line/cell_chain.h"

namespace csgsim::scan_line {

CellChain::CellChain(sc_core::sc_module_name name, const isa::ArrayShape& cells, std::uint32_t word_bits)
    : sc_core::sc_module(name), chain_(cells.width, cells.memory_bits, word_bits) {
  SC_HAS_PROCESS(CellChain);
  exit.bind(*this);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

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
  departed.write(++departed_count_);
  if (fill_clocks_ == 0) fill_clocks_ = periods_.count();
}

}  // namespace csgsim::scan_line
