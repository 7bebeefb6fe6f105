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

/// Takes the model from the link, a word a clock.
class ModelReceiver final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<isa::LinkWord> model{"model"};

  ModelReceiver(sc_core::sc_module_name name, const machines::Machine& machine)
      : systemc::ClockedModule(name), link_width_(machine.link.width) {}

  /// Starts at the next edge, with a model of so many bytes, one at least.
  void begin(std::uint64_t bytes);

  /// Happens at the edge at which the last word comes.
  [[nodiscard]] const sc_core::sc_event& received() const { return received_; }
  /// What has come, a byte an element.
  [[nodiscard]] const std::vector<isa::LinkWord>& bytes() const { return bytes_; }
  /// Until then.
  [[nodiscard]] const SquareClocks& clocks() const { return clocks_; }

 private:
  void on_clock() override;
  SquareActivity act();

  const std::uint32_t link_width_;
  std::vector<isa::LinkWord> bytes_;
  std::uint64_t bits_ = 0;  ///< that have come
  SquareClocks clocks_;
  sc_core::sc_event begun_{"begun"};
  sc_core::sc_event received_{"received"};
};

}  // namespace csgsim::pixel_square
