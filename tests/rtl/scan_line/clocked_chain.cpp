#include "tests/rtl/scan_line/clocked_chain.h"

#include "hw/scan_line/figures.h"
#include "hw/systemc/kernel.h"

namespace csgsim::rtl {

using scan_line::Figures;

ClockedChain::ClockedChain(const machines::Machine& machine)
    : sc_module(sc_core::sc_module_name("clocked_chain")),
      clock_("clock", systemc::period_of(machine)),
      words_("words", static_cast<int>(machine.link.fifo_depth)),
      accounts_("accounts", static_cast<int>(machine.array.width) + 2),
      host_("host", machines::kind_figures<Figures>(machine)),
      link_("link", machine.link),
      queue_("queue", machine, 0),
      chain_("chain", machine.array, scan_line::cell_shape(machines::kind_figures<Figures>(machine))) {
  host_.clock(clock_);
  host_.lines[0](lines_);
  link_.clock(clock_);
  link_.lines(lines_);
  link_.words(words_);
  queue_.clock(clock_);
  queue_.link(words_);
  queue_.entry(entry_);
  queue_.busy(entering_);
  queue_.accounts(accounts_);
  queue_.through(through_);
  queue_.retirement(retirement_);
  chain_.clock(clock_);
  chain_.entry(entry_);
  chain_.refresh(refresh_);
  chain_.accounts(accounts_);
  chain_.retirement(retirement_);
  sc_core::sc_start(clock_.period() * 0.5);
}

void ClockedChain::clear(std::uint32_t pixels) {
  queue_.forget_mark();
  chain_.clear(pixels);
}

void ClockedChain::begin(const scan_line::PictureLines& frame) {
  host_.begin(frame);
  link_.begin(frame, frame.lines.size());
  queue_.begin(frame);
  chain_.begin(frame.lines.size());
  retirement_.begin(nobody_, frame.lines.size());
}

void ClockedChain::clock() { sc_core::sc_start(clock_.period()); }

}  // namespace csgsim::rtl
