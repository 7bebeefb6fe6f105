#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <systemc>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/scan_line/account.h"
#include "hw/scan_line/cell_chain.h"
#include "hw/scan_line/chain_link.h"
#include "hw/scan_line/line_host.h"
#include "hw/scan_line/line_retirement.h"
#include "hw/scan_line/packet_queue.h"
#include "hw/scan_line/picture_lines.h"
#include "hw/scan_line/refresh_collector.h"
#include "hw/systemc/clock.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/guarded_listener.h"

namespace csgsim::scan_line {

/// The whole systolic scan-line array (thesis 7.2.2).
class ScanLineArray final : public sc_core::sc_module, public systemc::ClockedMachine {
 public:
  ScanLineArray(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Draws a frame of at least one line.
  systemc::RunReport run(const isa::Program& program, systemc::RunListener& listener) override;

  /// A frame begins when all marks of the previous frame have entered; the last lines of the previous frame are still
  /// shown at that time.
  std::vector<systemc::RunReport> run_sequence(std::span<const isa::Program> programs,
                                               std::span<systemc::RunListener* const> listeners) override;

  [[nodiscard]] std::vector<wave::Tap> taps(const isa::Program& program, const wave::Request& request) const override;

 private:
  /// Counts of host, links and entries for a frame after all its marks have entered.
  struct EnteredLines {
    ActivityCounter link;
    std::uint64_t words = 0;
    ActivityCounter entry;
    EntryCounts counts;
  };
  struct Entered {
    ActivityCounter host;
    std::vector<EnteredLines> chains;
  };

  /// A frame that has not been shown completely.
  struct Showing {
    const isa::Program* program;
    systemc::RunReport* report;
    Entered entered;
  };

  void on_entered();
  void on_shown();
  void clear(std::uint32_t line_pixels);
  void begin(const PictureLines& frame, systemc::RunListener& listener);
  void run_until_entered();
  void run_until_shown();
  void collect();
  [[nodiscard]] bool all_entered() const;
  [[nodiscard]] Entered entered() const;
  [[nodiscard]] LineAccount make_account(const Entered& entered, const ShownFrame& shown);
  [[nodiscard]] std::uint64_t edges() const;

  const machines::Machine machine_;
  systemc::Clock clock_;
  sc_core::sc_vector<sc_core::sc_fifo<std::uint32_t>> lines_;
  sc_core::sc_vector<sc_core::sc_fifo<isa::LinkWord>> words_;
  sc_core::sc_vector<sc_core::sc_signal<Beat>> entry_;
  sc_core::sc_vector<sc_core::sc_signal<bool>> entering_;
  sc_core::sc_vector<sc_core::sc_signal<RefreshPixel>> refresh_;
  sc_core::sc_vector<sc_core::sc_fifo<EntryAccount>> accounts_;
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> through_;
  sc_core::sc_signal<std::uint64_t> frames_{"frames"};

  LineHost host_;
  sc_core::sc_vector<ChainLink> links_;
  sc_core::sc_vector<PacketQueue> queues_;
  sc_core::sc_vector<CellChain> chains_;
  RefreshCollector collector_;
  sc_core::sc_vector<LineRetirement> retirements_;

  std::deque<Showing> showing_;  ///< the oldest first
  std::uint64_t shown_ = 0;      ///< number of frames shown, over all runs
};

}  // namespace csgsim::scan_line
