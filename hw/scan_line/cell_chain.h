#pragma once

#include <cstdint>
#include <systemc>

#include "hw/isa/program.h"
#include "hw/scan_line/chain.h"
#include "hw/scan_line/packet_signals.h"
#include "hw/scan_line/periods.h"
#include "hw/systemc/clocked_module.h"
#include "hw/systemc/retirement.h"

namespace csgsim::scan_line {

/// A whole chain as one module: a packet's beat enters cell 0 each clock, and a pixel leaves at the refresh port. What
/// leaves the last cell of a line has been carried out.
class CellChain final : public systemc::ClockedModule {
 public:
  sc_core::sc_in<PacketWord> entry{"entry"};
  sc_core::sc_out<RefreshPixel> refresh{"refresh"};
  sc_core::sc_fifo_in<EntryAccount> accounts{"accounts"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  CellChain(sc_core::sc_module_name name, const isa::ArrayShape& cells, const CellShape& shape);

  /// For lines of that many pixels.
  void begin(std::uint32_t pixels);

  [[nodiscard]] const Chain& chain() const { return chain_; }

  /// Clocks until a packet was in the last cell of a line for the first time; 0 if none has been.
  [[nodiscard]] std::uint64_t fill_clocks() const { return fill_clocks_; }

 private:
  void on_clock() override;
  void retire(const Departure& departure);

  Chain chain_;
  Periods periods_;
  std::uint64_t fill_clocks_ = 0;
};

}  // namespace csgsim::scan_line
