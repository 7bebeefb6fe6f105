#pragma once

#include <systemc>

#include "hw/machines/machine.h"
#include "hw/scan_line/account.h"
#include "hw/scan_line/cell_chain.h"
#include "hw/scan_line/chain_link.h"
#include "hw/scan_line/line_host.h"
#include "hw/scan_line/packet_queue.h"
#include "hw/scan_line/picture_lines.h"
#include "hw/scan_line/refresh_collector.h"
#include "hw/systemc/clock.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/retirement.h"

namespace csgsim::scan_line {

/// The whole systolic scan-line array (thesis 7.2.2).
class ScanLineArray final : public sc_core::sc_module, public systemc::ClockedMachine {
 public:
  ScanLineArray(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Draws a frame of one line or more.
  systemc::RunReport run(const isa::Program& program, systemc::RunListener& listener) override;

  [[nodiscard]] std::vector<wave::Tap> taps(const isa::Program& program, const wave::Request& request) const override;

 private:
  void on_done();
  void draw(const PictureLines& frame, systemc::RunListener& listener);
  [[nodiscard]] LineAccount counted() const;
  [[nodiscard]] std::uint64_t interval(const PictureLines& frame) const;

  const machines::Machine machine_;
  systemc::Clock clock_;
  sc_core::sc_vector<sc_core::sc_fifo<std::uint32_t>> lines_;
  sc_core::sc_vector<sc_core::sc_fifo<isa::LinkWord>> words_;
  sc_core::sc_vector<sc_core::sc_signal<PacketWord>> entry_;
  sc_core::sc_vector<sc_core::sc_signal<bool>> entering_;
  sc_core::sc_vector<sc_core::sc_signal<RefreshPixel>> refresh_;
  sc_core::sc_vector<sc_core::sc_fifo<EntryAccount>> accounts_;
  sc_core::sc_signal<std::uint64_t> frames_{"frames"};

  LineHost host_;
  sc_core::sc_vector<ChainLink> links_;
  sc_core::sc_vector<PacketQueue> queues_;
  sc_core::sc_vector<CellChain> chains_;
  RefreshCollector collector_;
  systemc::Retirement retirement_{"retirement"};
};

}  // namespace csgsim::scan_line
