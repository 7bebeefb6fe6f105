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

/// Samples a wave's taps in the middle of each clock of its windows, when every wire has settled. It stands beside a
/// machine, is no part of it, and costs nothing outside the windows.
class WaveRecorder final : public sc_core::sc_module {
 public:
  /// `period`: of the machine's clock.
  WaveRecorder(sc_core::sc_module_name name, const sc_core::sc_time& period);

  /// Records the run that begins at this time. `first_clock`: the frame's clock that the next rising edge begins.
  /// `stops`: the simulation ends with the last window (systemc::stop).
  void arm(std::unique_ptr<wave::Writer> writer, std::vector<wave::Window> windows, std::uint64_t first_clock,
           bool stops);

  /// Wall time that sampling, and writing the file, have taken since arm.
  [[nodiscard]] std::chrono::duration<double> writing() const { return writing_; }

  /// Ends the file. Says whether a window was reached. What writing threw during the run comes out here.
  bool finish();

 private:
  void proceed();

  sc_core::sc_time period_;
  sc_core::sc_event next_{"next"};
  std::unique_ptr<wave::Writer> writer_;
  std::vector<wave::Window> windows_;
  std::size_t window_ = 0;   ///< that is being recorded, or comes next
  std::uint64_t clock_ = 0;  ///< of the frame, in which it samples next
  std::chrono::duration<double> writing_{};
  ListenerGuard guard_;  ///< of what is written: nothing that it throws may reach the kernel
  bool stops_ = false;
  bool reached_ = false;
};

}  // namespace csgsim::systemc
