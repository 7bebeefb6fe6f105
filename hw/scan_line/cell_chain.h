#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <systemc>

#include "hw/isa/program.h"
#include "hw/scan_line/chain.h"
#include "hw/scan_line/packet_signals.h"
#include "hw/scan_line/periods.h"
#include "hw/systemc/clocked_module.h"
#include "hw/systemc/retirement.h"

namespace csgsim::scan_line {

/// Counts of a chain in one frame.
struct CellCounts {
  std::uint64_t fill_clocks = 0;  ///< clocks until a packet first reached the last cell of a line; 0 if no packet did
  std::uint64_t busy_cells = 0;   ///< sum of Departure::busy_cells over all packets
};

/// A whole chain as one module: each clock, a beat of a packet enters cell 0 and a pixel leaves at the refresh port. A
/// packet is completed when it leaves the last cell of a line.
class CellChain final : public systemc::ClockedModule {
 public:
  sc_core::sc_in<Beat> entry{"entry"};
  sc_core::sc_out<RefreshPixel> refresh{"refresh"};
  sc_core::sc_fifo_in<EntryAccount> accounts{"accounts"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  CellChain(sc_core::sc_module_name name, const isa::ArrayShape& cells, const CellShape& shape);

  /// Empties the chain; the following lines have `line_pixels` pixels.
  void clear(std::uint32_t line_pixels);

  /// Begins a frame of `line_count` lines. Lines of earlier frames may still be in the cells.
  void begin(std::size_t line_count);

  /// Removes and returns the counts of the oldest frame. All its lines must have left the cells.
  CellCounts pop_counts();

  [[nodiscard]] const Chain& chain() const { return chain_; }

 private:
  void on_clock() override;
  struct Frame {
    std::size_t lines_left = 0;  ///< lines that have not left the cells
    Periods periods{};           ///< clock periods since the frame began
    CellCounts counts{};
  };

  [[nodiscard]] Frame& leaving();
  void retire(const Departure& departure);

  Chain chain_;
  std::deque<Frame> frames_;  ///< frames whose counts have not been removed with pop_counts()
};

}  // namespace csgsim::scan_line
