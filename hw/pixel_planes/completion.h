// Reports executed instructions to the listener of a run.
// Used by the Pixel-planes machine.
#pragma once

#include <cstdint>
#include <span>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/timing.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/pixel_ports.h"
#include "hw/systemc/retirement.h"

namespace csgsim::pixel_planes {

/// Reports each executed instruction, with the controller's counts, to the listener of the run. It is not hardware: it
/// takes no clock and acts between the edge that executes an instruction and the next edge. It reads the Program to
/// determine the segment of an instruction.
class Completion final : public sc_core::sc_module {
 public:
  sc_core::sc_in<std::uint64_t> retired{"retired"};
  sc_core::sc_fifo_in<Account> accounts{"accounts"};
  sc_core::sc_port<EnableLines> enable{"enable"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  explicit Completion(sc_core::sc_module_name name);

  /// Begins a frame. The segments must outlive it.
  void begin(std::span<const isa::Segment> segments);

  /// Sets the instruction that is reported next, for a run that starts in the middle of a frame; called after begin().
  void resume(std::uint32_t segment, std::uint32_t index);

  /// Results of the global-OR tests that were sent to the host since begin(), in order.
  [[nodiscard]] const std::vector<bool>& answers() const { return answers_; }

  /// Number of skipped instructions since begin(). skips() lists the global-OR tests that caused them.
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }
  [[nodiscard]] const std::vector<machines::Skip>& skips() const { return skips_; }

 private:
  void complete();
  void report(const Account& account);
  void finish_segment();

  std::span<const isa::Segment> segments_;
  std::uint64_t reported_ = 0;  ///< number of completed commands since construction
  std::uint32_t segments_begun_ = 0;
  std::uint32_t index_ = 0;
  std::uint64_t enabled_ = 0;
  std::uint64_t skipped_ = 0;
  std::vector<machines::Skip> skips_;
  std::vector<bool> answers_;
};

}  // namespace csgsim::pixel_planes
