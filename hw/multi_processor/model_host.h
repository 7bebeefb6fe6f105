#pragma once

#include <cstdint>
#include <span>
#include <systemc>

#include "hw/isa/link_word.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// Bits of the model's length in bytes, which the host sends first.
inline constexpr unsigned length_bits = 32;

/// The host: once per frame, sends the length of the display model and then its bytes, one word every
/// `host.link_word_clocks` clocks after `host.link_latency` clocks.
class ModelHost final : public sc_core::sc_module {
 public:
  sc_core::sc_out<HostWord> word{"word"};

  ModelHost(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Starts at the next delta cycle. The bytes must outlive the frame.
  void begin(std::span<const std::uint8_t> model);

 private:
  void work();
  [[nodiscard]] isa::LinkWord link_word_at(std::uint64_t first_bit) const;
  [[nodiscard]] std::uint64_t bits() const { return length_bits + 8 * std::uint64_t{model_.size()}; }

  TimeBase time_;
  const HostLink link_;
  std::span<const std::uint8_t> model_;
  std::uint64_t words_ = 0;  ///< words sent, over all frames
  sc_core::sc_event start_{"start"};
};

}  // namespace csgsim::multi_processor
