#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/systemc/run_listener.h"
#include "sim/cycle/in_order.h"

namespace csgsim::cycle {

/// Passes what a machine tells on to the observers in program order, and counts the overflows, which the machine does
/// not notice.
class Relay final : public systemc::RunListener {
 public:
  /// Both have to live until the run is done.
  Relay(const isa::Program& program, std::span<engine::Observer* const> observers)
      : program_(program), in_order_(program, observers) {}

  [[nodiscard]] systemc::Keep keeps_after(std::uint32_t segment, std::uint32_t index) override;
  void after_instruction(const systemc::Retired& retired, const systemc::PixelView& pixels) override;
  void after_segment(std::uint32_t segment, const systemc::PixelView& pixels) override;

  [[nodiscard]] std::uint64_t overflows() const { return overflows_; }
  /// What was skipped, in program order.
  [[nodiscard]] std::vector<machines::Skip> skips() const;

 private:
  void count_overflows_of_next(const systemc::Retired& retired, const systemc::PixelView& pixels);

  const isa::Program& program_;
  InOrder in_order_;
  std::vector<std::uint64_t> enable_;
  std::uint64_t overflows_ = 0;
  std::vector<machines::Skip> skips_;  ///< in the order in which the machine comes to them
};

}  // namespace csgsim::cycle
