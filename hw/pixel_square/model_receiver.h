#pragma once

#include <cstdint>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/account.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::pixel_square {

/// Receives the model from the link, one word per clock.
class ModelReceiver final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<isa::LinkWord> model{"model"};

  ModelReceiver(sc_core::sc_module_name name, const machines::Machine& machine)
      : systemc::ClockedModule(name), link_width_(machine.link.width) {}

  /// Starts at the next edge; `bytes` is the size of the model, at least 1.
  void begin(std::uint64_t bytes);

  /// Notified at the edge at which the last word arrives.
  [[nodiscard]] const sc_core::sc_event& received() const { return received_; }
  /// The received model, one byte per element.
  [[nodiscard]] const std::vector<isa::LinkWord>& bytes() const { return bytes_; }
  /// Activities until the model is complete.
  [[nodiscard]] const SquareClocks& clocks() const { return clocks_; }

 private:
  void on_clock() override;
  SquareActivity act();

  const std::uint32_t link_width_;
  std::vector<isa::LinkWord> bytes_;
  std::uint64_t bits_ = 0;  ///< number of bits received
  SquareClocks clocks_;
  sc_core::sc_event begun_{"begun"};
  sc_core::sc_event received_{"received"};
};

}  // namespace csgsim::pixel_square
