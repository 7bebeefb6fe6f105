// Samples taps into a wave file.
// Used by sim/waves and tests.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <systemc>
#include <vector>

#include "hw/systemc/listener_guard.h"
#include "hw/wave/request.h"
#include "hw/wave/writer.h"

namespace csgsim::systemc {

/// Samples the taps of a wave in the middle of each clock of its windows, when all wires have settled. It is not part
/// of the machine and takes no time outside the windows.
class WaveRecorder final : public sc_core::sc_module {
 public:
  /// `period`: period of the machine's clock.
  WaveRecorder(sc_core::sc_module_name name, const sc_core::sc_time& period);

  /// Records the run that begins now. `first_clock`: number within the frame of the clock that the next rising edge
  /// begins. `stops_after_last_window`: whether the simulation stops after the last window (systemc::stop).
  void arm(std::unique_ptr<wave::Writer> writer, std::vector<wave::Window> windows, std::uint64_t first_clock,
           bool stops_after_last_window);

  /// Wall time spent on sampling and writing since arm().
  [[nodiscard]] std::chrono::duration<double> writing() const { return writing_; }

  /// Ends the file. Returns whether a window was reached. Rethrows an exception that the writer threw during the run.
  bool finish();

 private:
  void proceed();

  sc_core::sc_time period_;
  sc_core::sc_event next_{"next"};
  std::unique_ptr<wave::Writer> writer_;
  std::vector<wave::Window> windows_;
  std::size_t window_ = 0;   ///< current or next window
  std::uint64_t clock_ = 0;  ///< clock of the frame for the next sample
  std::chrono::duration<double> writing_{};
  ListenerGuard guard_;  ///< keeps the writer's exceptions away from the kernel
  bool stops_ = false;
  bool reached_ = false;
};

}  // namespace csgsim::systemc
