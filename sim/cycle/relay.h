// Forwards the events of a clocked machine to the observers.
// Used by the cycle engine and tests.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/systemc/run_listener.h"
#include "sim/cycle/in_order.h"

namespace csgsim::cycle {

/// Forwards the machine's events to the observers in program order, and counts overflows, which the machine does not
/// detect.
class Relay final : public systemc::RunListener {
 public:
  /// Both arguments must outlive the run.
  Relay(const isa::Program& program, std::span<engine::Observer* const> observers)
      : program_(program), in_order_(program, observers) {}

  [[nodiscard]] systemc::Keep required_after(std::uint32_t segment, std::uint32_t index) override;
  void after_instruction(const systemc::Retired& retired, const systemc::PixelView& pixels) override;
  void after_segment(std::uint32_t segment, const systemc::PixelView& pixels) override;

  [[nodiscard]] std::uint64_t overflows() const { return overflows_; }
  /// The skips, in program order.
  [[nodiscard]] std::vector<machines::Skip> skips() const;

 private:
  void count_overflows_of_next(const systemc::Retired& retired, const systemc::PixelView& pixels);

  const isa::Program& program_;
  ProgramOrderBuffer in_order_;
  std::vector<std::uint64_t> enable_;
  std::uint64_t overflows_ = 0;
  std::vector<machines::Skip> skips_;  ///< in the order in which the machine reaches them
};

}  // namespace csgsim::cycle
