// Forwards executed instructions to the listener.
// Used by hw/bit_serial_memory, hw/multi_processor, hw/pixel_planes, hw/pixel_square and hw/scan_line.
#pragma once

#include <cstdint>
#include <optional>
#include <systemc>

#include "hw/systemc/guarded_listener.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::systemc {

/// Port through which modules report executed instructions.
class RetirementPort : virtual public sc_core::sc_interface, public RunListener {};

/// Forwards reports of executed instructions to the listener of the run. Takes no clock.
class Retirement final : public sc_core::sc_module, public RetirementPort {
 public:
  explicit Retirement(sc_core::sc_module_name name);

  /// Begins a run; the listener must outlive it.
  void begin(RunListener& listener);

  /// Rethrows the listener's exception, if any, after the machine has completed its run.
  void rethrow() { listener_->rethrow(); }

  [[nodiscard]] Keep required_after(std::uint32_t segment, std::uint32_t index) override;
  void after_instruction(const Retired& retired, const PixelView& pixels) override;
  void after_segment(std::uint32_t segment, const PixelView& pixels) override;

 private:
  std::optional<GuardedListener> listener_;
};

}  // namespace csgsim::systemc
