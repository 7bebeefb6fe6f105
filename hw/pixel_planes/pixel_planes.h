#pragma once

#include <cstdint>
#include <optional>
#include <systemc>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/isa/program.h"
#include "hw/link/link_source.h"
#include "hw/machines/machine.h"
#include "hw/pixel_planes/completion.h"
#include "hw/pixel_planes/control_delay.h"
#include "hw/pixel_planes/controller.h"
#include "hw/pixel_planes/global_or.h"
#include "hw/pixel_planes/linear_expression_evaluator.h"
#include "hw/pixel_planes/pixel_processors.h"
#include "hw/pixel_planes/plane_channel.h"
#include "hw/pixel_planes/scan_out.h"
#include "hw/pixel_planes/wave.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/retirement.h"

namespace csgsim::pixel_planes {

struct ShownFrame {
  std::uint64_t clocks = 0;
  std::uint64_t latch_clocks = 0;      ///< of these, until pixel memory may change
  std::vector<std::uint32_t> colours;  ///< in row order, the array's width a row
};

/// The whole Pixel-planes machine.
class PixelPlanes final : public sc_core::sc_module, public kernel::ClockedMachine {
 public:
  PixelPlanes(sc_core::sc_module_name name, const machines::Machine& machine);

  /// A frame begins with the clock in which the controller asks for it and ends when its last step has been carried
  /// out; then a Program with colours is scanned out.
  kernel::RunReport run(const isa::Program& program, kernel::RunListener& listener) override;

  /// The next frame begins when the last row of the one before it has been latched, and is drawn while that is shown.
  std::vector<kernel::RunReport> run_sequence(std::span<const isa::Program> programs,
                                              std::span<kernel::RunListener* const> listeners) override;

  [[nodiscard]] bool can_record() const override { return true; }
  void record(const WaveRequest& request) override;

  /// Scans the field out of the memory that the last program left.
  ShownFrame scan_out(isa::Field colour);

  [[nodiscard]] const PixelProcessors& processors() const { return processors_; }
  [[nodiscard]] const Controller& controller() const { return controller_; }
  [[nodiscard]] unsigned latency() const { return latency_; }
  [[nodiscard]] sc_core::sc_time period() const { return clock_.period(); }

 private:
  void elaborate();
  kernel::RunReport draw(const isa::Program& program, kernel::RunListener& listener);
  bool clock_program(const std::optional<WaveRequest>& wave);
  void show(const isa::Program& program, kernel::RunReport& report);
  template <class Condition>
  void run_until(const Condition& holds);
  [[nodiscard]] std::uint64_t edges() const;
  void on_done();

  const machines::Machine machine_;
  const unsigned latency_;

  sc_core::sc_clock clock_;
  sc_core::sc_fifo<isa::LinkWord> link_;
  sc_core::sc_fifo<std::uint64_t> requests_{"requests", 1};
  sc_core::sc_fifo<RefreshStep> refreshes_{"refreshes", 2};  ///< two, so that one goes through in each clock
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
  sc_core::sc_signal<std::uint64_t> latched_{"latched"};
  sc_core::sc_signal<std::uint64_t> frames_{"frames"};

  link::LinkSource host_;
  Controller controller_;
  ControlDelay control_delay_;
  LinearExpressionEvaluator evaluator_;
  PixelProcessors processors_;
  GlobalOr global_or_;
  Completion completion_{"completion"};
  kernel::Retirement retirement_{"retirement"};
  ScanOut scan_out_;
  WaveRecorder wave_;
  std::optional<WaveRequest> wave_request_;
};

}  // namespace csgsim::pixel_planes
