#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"
#include "hw/scan_line/cell_chain.h"
#include "hw/scan_line/frame.h"
#include "hw/scan_line/packet_queue.h"
#include "hw/scan_line/refresh_collector.h"
#include "hw/scan_line/retirement.h"

namespace csgsim::scan_line {

struct RunReport {
  std::uint64_t clocks = 0;
  machines::LineAccount account;
};

/// The whole systolic scan-line array (thesis 7.2.2). SystemC elaborates once a process, so there can be one in a
/// process; it draws any number of frames one after the other. From its construction on, a SystemC warning is an
/// exception.
class ScanLineArray final : public sc_core::sc_module {
 public:
  ScanLineArray(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Draws a frame of one line or more, which has to fit the machine (machines::check_runs_on). What the listener
  /// throws comes out when the machine is done.
  RunReport run(const Frame& frame);

  /// The last frame's lines as the refresh ports delivered them, in the frame's order.
  [[nodiscard]] const std::vector<std::vector<std::uint32_t>>& lines() const { return collector_.lines(); }

 private:
  void on_done();
  [[nodiscard]] machines::LineAccount account(const Frame& frame) const;

  const machines::Machine machine_;
  sc_core::sc_clock clock_;
  sc_core::sc_vector<sc_core::sc_signal<PacketWord>> entry_;
  sc_core::sc_vector<sc_core::sc_signal<bool>> entering_;
  sc_core::sc_vector<sc_core::sc_signal<RefreshPixel>> refresh_;
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> departed_;
  sc_core::sc_vector<sc_core::sc_fifo<EntryAccount>> accounts_;
  sc_core::sc_signal<std::uint64_t> frames_{"frames"};

  sc_core::sc_vector<PacketQueue> queues_;
  sc_core::sc_vector<CellChain> chains_;
  sc_core::sc_vector<Retirement> retirements_;
  RefreshCollector collector_;
};

}  // namespace csgsim::scan_line
