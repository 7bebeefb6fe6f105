#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <systemc>
#include <vector>

#include "hw/bit_serial_memory/controller.h"
#include "hw/bit_serial_memory/memory_view.h"
#include "hw/isa/program.h"
#include "hw/machines/run_outcome.h"
#include "hw/systemc/retirement.h"

namespace csgsim::bit_serial_memory {

/// Determines which instruction the controller has executed, and reports it to run listeners. Takes no clock.
class Completion final : public sc_core::sc_module, public ProgressPort {
 public:
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  Completion(sc_core::sc_module_name name, const MemoryView& pixels) : sc_core::sc_module(name), pixels_(pixels) {}

  /// The segments must outlive the frame.
  void begin(std::span<const isa::Segment> segments);

  void before_instruction() override { enabled_ = pixels_.count_enabled(); }
  void after_clear() override;
  void after_instruction(std::uint64_t clocks, std::optional<bool> answer, std::uint64_t skipped) override;

  [[nodiscard]] const std::vector<bool>& answers() const { return answers_; }
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }

 private:
  void finish_segment();

  const MemoryView& pixels_;
  std::span<const isa::Segment> segments_;
  std::uint32_t begun_ = 0;  ///< number of segments begun
  std::uint32_t index_ = 0;
  std::uint64_t enabled_ = 0;
  std::uint64_t skipped_ = 0;
  std::vector<bool> answers_;
};

}  // namespace csgsim::bit_serial_memory
