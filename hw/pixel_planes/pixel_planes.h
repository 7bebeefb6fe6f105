// The Pixel-planes machine in SystemC.
// Used by its maker and by tests.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <systemc>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/isa/program.h"
#include "hw/link/link_source.h"
#include "hw/machines/machine.h"
#include "hw/pixel_planes/completion.h"
#include "hw/pixel_planes/controller.h"
#include "hw/pixel_planes/global_or.h"
#include "hw/pixel_planes/pixel_pipeline.h"
#include "hw/pixel_planes/probed.h"
#include "hw/pixel_planes/scan_out.h"
#include "hw/systemc/clock.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/earlier_run.h"
#include "hw/systemc/evaluator_form.h"
#include "hw/systemc/retirement.h"

namespace csgsim::pixel_planes {

/// The whole Pixel-planes machine.
class PixelPlanes final : public sc_core::sc_module, public systemc::ClockedMachine {
 public:
  /// If `earlier` is not null, only the pixels of that run are simulated. This supports only Programs of one segment,
  /// and the reported picture is meaningless.
  PixelPlanes(sc_core::sc_module_name name, const machines::Machine& machine,
              systemc::EvaluatorForm form = systemc::EvaluatorForm::computed,
              const systemc::EarlierRun* earlier = nullptr);

  /// A frame begins with the clock in which the controller requests it and ends when its last step has been executed;
  /// then the picture of a Program with a displayed field is scanned out.
  systemc::RunReport run(const isa::Program& program, systemc::RunListener& listener) override;

  /// Runs frames in sequence. With one buffer a frame begins when the last row of the previous picture has been
  /// latched. With two, it begins when the previous picture has been copied, and is drawn while that picture is
  /// displayed. The interval of the last frame is computed, since no frame follows. With two buffers, also throws
  /// InputError if the frames' colour fields differ in width.
  std::vector<systemc::RunReport> run_sequence(std::span<const isa::Program> programs,
                                               std::span<systemc::RunListener* const> listeners) override;

  [[nodiscard]] std::vector<wave::Tap> taps(const isa::Program& program, const wave::Request& request) const override;

  /// Supported only if only some pixels are simulated: the run begins at an instruction shortly before the window.
  std::uint64_t skip_to(const isa::Program& program, wave::Window window) override;

  [[nodiscard]] const PixelPipeline& processors() const { return pipeline_; }
  [[nodiscard]] const Controller& controller() const { return controller_; }
  [[nodiscard]] unsigned latency() const { return latency_; }
  [[nodiscard]] sc_core::sc_time period() const { return clock_.period(); }

 private:
  /// A frame whose picture the scan-out has not completely shown.
  struct Showing {
    std::uint64_t begun;  ///< edge at which the frame began
    bool fills_array;     ///< whether the array holds the whole picture
    systemc::RunReport* report;
  };

  void start_frame(const isa::Program& program);
  void resume(const isa::Program& program, const Start& start);
  void check_programs(std::span<const isa::Program> programs) const;
  [[nodiscard]] std::vector<wave::Tap> host_taps() const;
  [[nodiscard]] std::vector<wave::Tap> controller_taps(const isa::Program& program) const;
  [[nodiscard]] std::vector<wave::Tap> scan_out_taps() const;
  void draw_frame(const isa::Program& program, systemc::RunListener& listener, systemc::RunReport& report);
  void collect();
  void run_until_shown();
  [[nodiscard]] std::uint64_t edges() const;
  void on_done();

  const machines::Machine machine_;
  const std::optional<systemc::EarlierRun> earlier_;
  const unsigned latency_;

  systemc::Clock clock_;
  sc_core::sc_fifo<isa::LinkWord> link_;
  sc_core::sc_fifo<std::uint64_t> requests_{"requests", 1};
  sc_core::sc_fifo<bool> waiting_frames_{"waiting_frames", 1};
  sc_core::sc_fifo<RefreshStep> refreshes_{"refreshes", 2};  ///< two entries, so that one passes in each clock
  sc_core::sc_fifo<FinishedPicture> pictures_{"pictures", 1};
  sc_core::sc_fifo<bool> latched_{"latched", 1};
  sc_core::sc_signal<bool> question_{"question"};
  sc_core::sc_signal<Answer> answer_{"answer"};
  sc_core::sc_signal<std::uint64_t> retired_{"retired"};
  sc_core::sc_fifo<Account> accounts_;
  sc_core::sc_signal<std::uint64_t> programs_{"programs"};
  sc_core::sc_signal<std::uint64_t> frames_{"frames"};

  link::LinkSource host_;
  Controller controller_;
  PixelPipeline pipeline_;
  GlobalOr global_or_;
  Completion completion_{"completion"};
  systemc::Retirement retirement_{"retirement"};
  ScanOut scan_out_;
  std::optional<Start> start_;   ///< start of the next frame, if it is not at the beginning
  std::deque<Showing> showing_;  ///< oldest first
  std::uint64_t begun_ = 0;      ///< edge at which the last drawn frame began
  std::uint64_t drawn_ = 0;      ///< value of programs_ last seen
  std::uint64_t shown_ = 0;      ///< value of frames_ last seen
};

}  // namespace csgsim::pixel_planes
