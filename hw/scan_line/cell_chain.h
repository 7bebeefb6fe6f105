#pragma once

#include <cstdint>
#include <systemc>

#include "hw/isa/program.h"
#include "hw/scan_line/chain.h"
#include "hw/scan_line/frame.h"
#include "hw/scan_line/words.h"

namespace csgsim::scan_line {

/// What leaves the last cell of a line.
class ChainExit : virtual public sc_core::sc_interface {
 public:
  /// In the clock that has just been; until the next edge.
  [[nodiscard]] virtual const Departure& departure() const = 0;
};

/// A whole chain as one module: a packet's word enters cell 0 each clock, and a pixel leaves at the refresh port.
class CellChain final : public sc_core::sc_module, public ChainExit {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<PacketWord> entry{"entry"};
  sc_core::sc_out<RefreshPixel> refresh{"refresh"};
  sc_core::sc_out<std::uint64_t> departed{"departed"};  ///< packets and marks that have left the last cell of a line
  sc_core::sc_export<ChainExit> exit{"exit"};

  CellChain(sc_core::sc_module_name name, const isa::ArrayShape& cells, std::uint32_t word_bits);

  /// For lines of that many pixels.
  void begin(std::uint32_t pixels);

  [[nodiscard]] const Departure& departure() const override { return chain_.departure(); }
  [[nodiscard]] const Chain& chain() const { return chain_; }

  /// Clocks until a packet or mark was in the last cell of a line for the first time; 0 if none has been.
  [[nodiscard]] std::uint64_t fill_clocks() const { return fill_clocks_; }

 private:
  void on_clock();

  Chain chain_;
  Periods periods_;
  std::uint64_t fill_clocks_ = 0;
  std::uint64_t departed_count_ = 0;
};

}  // namespace csgsim::scan_line
