#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_planes/control_delay.h"
#include "hw/pixel_planes/controller.h"
#include "hw/pixel_planes/global_or.h"
#include "hw/pixel_planes/host_link.h"
#include "hw/pixel_planes/linear_expression_evaluator.h"
#include "hw/pixel_planes/pixel_processors.h"
#include "hw/pixel_planes/plane_channel.h"
#include "hw/pixel_planes/retirement.h"
#include "hw/pixel_planes/scan_out.h"
#include "hw/pixel_planes/wave.h"

namespace csgsim::pixel_planes {

struct RunReport {
  std::uint64_t clocks = 0;          ///< from the first step on the wires until the last has been carried out
  std::uint64_t latency_clocks = 0;  ///< of these, after the last instruction's
  std::uint64_t skipped = 0;         ///< instructions that were not carried out
  std::vector<bool> answers;         ///< to the host's questions, in order
  bool recorded = false;             ///< the run reached the window of clocks that was to be recorded
};

struct Frame {
  std::uint64_t clocks = 0;
  std::vector<std::uint32_t> colours;  ///< in row order, the array's width a row
};

/// The whole Pixel-planes machine. SystemC elaborates once a process, so there can be one in a process; it runs any
/// number of programs one after the other. From its construction on, a SystemC warning is an exception.
class PixelPlanes final : public sc_core::sc_module {
 public:
  PixelPlanes(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Runs the segments, one straight after the other: they have to be valid (isa::validate) for the machine's array.
  /// What the listener throws comes out when the machine is done.
  RunReport run(std::span<const isa::Segment> segments, RunListener& listener);

  /// Has the next run recorded. Throws std::invalid_argument for a probe or field outside the array.
  void record(WaveRequest request);

  /// Scans the field out of the memory that the last program left.
  Frame scan_out(isa::Field colour);

  [[nodiscard]] const PixelProcessors& processors() const { return processors_; }
  [[nodiscard]] const Controller& controller() const { return controller_; }
  [[nodiscard]] unsigned latency() const { return latency_; }
  [[nodiscard]] sc_core::sc_time period() const { return clock_.period(); }

 private:
  void elaborate();
  void on_done();

  unsigned latency_;

  sc_core::sc_clock clock_;
  sc_core::sc_fifo<HostWord> link_;
  sc_core::sc_fifo<std::uint64_t> jumps_{"jumps", 1};
  sc_core::sc_signal<RootWord> root_{"root_bits"};
  sc_core::sc_signal<ControlWord> control_{"control"};
  sc_core::sc_signal<ControlWord> control_at_pixels_{"control_at_pixels"};
  sc_core::sc_signal<bool> question_{"question"};
  sc_core::sc_signal<Answer> answer_{"answer"};
  PlaneChannel tree_bits_;
  sc_core::sc_signal<std::uint64_t> retired_{"retired"};
  sc_core::sc_fifo<Account> accounts_;
  sc_core::sc_signal<std::uint64_t> programs_{"programs"};
  sc_core::sc_signal<std::uint32_t> video_{"video"};
  sc_core::sc_signal<std::uint64_t> frames_{"frames"};

  HostLink host_{"host"};
  Controller controller_;
  ControlDelay control_delay_;
  LinearExpressionEvaluator evaluator_;
  PixelProcessors processors_;
  GlobalOr global_or_{"global_or"};
  Retirement retirement_{"retirement"};
  ScanOut scan_out_;
  WaveRecorder wave_;
  std::optional<WaveRequest> wave_request_;
};

}  // namespace csgsim::pixel_planes
