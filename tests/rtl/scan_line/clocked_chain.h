#pragma once

#include <cstdint>
#include <systemc>

#include "hw/machines/machine.h"
#include "hw/scan_line/cell_chain.h"
#include "hw/scan_line/chain_link.h"
#include "hw/scan_line/line_host.h"
#include "hw/scan_line/line_retirement.h"
#include "hw/scan_line/packet_queue.h"
#include "hw/systemc/clock.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::rtl {

/// A SystemC chain with its host, link and packet queue, run clock by clock.
class ClockedChain final : public sc_core::sc_module {
 public:
  explicit ClockedChain(const machines::Machine& machine);

  /// Prepares for lines of that many pixels; the chain must be empty.
  void clear(std::uint32_t pixels);
  /// Starts a frame after all marks of the previous one have entered. `frame` must live until its own have.
  void begin(const scan_line::PictureLines& frame);
  [[nodiscard]] bool is_through() const { return queue_.all_marks_entered(); }

  /// Advances to the middle of the next clock, when all signals have settled.
  void clock();

  /// The contents of cell 0 in this clock, valid until its end.
  [[nodiscard]] const scan_line::Beat& entry() const { return entry_.read(); }
  [[nodiscard]] const scan_line::RefreshPixel& refresh() const { return refresh_.read(); }
  [[nodiscard]] const scan_line::Chain& chain() const { return chain_.chain(); }

 private:
  systemc::Clock clock_;
  sc_core::sc_fifo<std::uint32_t> lines_{"lines", 1};
  sc_core::sc_fifo<isa::LinkWord> words_;
  sc_core::sc_signal<scan_line::Beat> entry_{"entry"};
  sc_core::sc_signal<bool> entering_{"entering"};
  sc_core::sc_signal<scan_line::RefreshPixel> refresh_{"refresh"};
  sc_core::sc_fifo<scan_line::EntryAccount> accounts_;
  sc_core::sc_signal<std::uint64_t> through_{"through"};
  scan_line::LineHost host_;
  scan_line::ChainLink link_;
  scan_line::PacketQueue queue_;
  scan_line::CellChain chain_;
  scan_line::LineRetirement retirement_{"retirement"};
  systemc::RunListener nobody_;
};

}  // namespace csgsim::rtl
