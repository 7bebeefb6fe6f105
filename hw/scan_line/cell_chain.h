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

/// What a chain counted of a frame.
struct CellCounts {
  std::uint64_t fill_clocks = 0;  ///< until a packet was in the last cell of a line for the first time; 0: none was
  std::uint64_t busy_cells = 0;   ///< as Departure has them, of all packets
};

/// A whole chain as one module: a packet's beat enters cell 0 each clock, and a pixel leaves at the refresh port. What
/// leaves the last cell of a line has been carried out.
class CellChain final : public systemc::ClockedModule {
 public:
  sc_core::sc_in<Beat> entry{"entry"};
  sc_core::sc_out<RefreshPixel> refresh{"refresh"};
  sc_core::sc_fifo_in<EntryAccount> accounts{"accounts"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  CellChain(sc_core::sc_module_name name, const isa::ArrayShape& cells, const CellShape& shape);

  /// Empties the chain, for lines of that many pixels.
  void clear(std::uint32_t pixels);

  /// A frame begins, of which so many lines come. Lines of those before may still be in the cells.
  void begin(std::size_t lines);

  /// What was counted of the oldest frame that has not been taken, all lines of which have left the cells.
  CellCounts take();

  [[nodiscard]] const Chain& chain() const { return chain_; }

 private:
  void on_clock() override;
  struct Frame {
    std::size_t lines_left = 0;  ///< that have not left the cells
    Periods periods{};           ///< since it began
    CellCounts counts{};
  };

  [[nodiscard]] Frame& leaving();
  void retire(const Departure& departure);

  Chain chain_;
  std::deque<Frame> frames_;  ///< that have not been taken
};

}  // namespace csgsim::scan_line
