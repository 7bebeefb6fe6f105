#include <deque>
#include <systemc>

#include "hw/array/linear_evaluator.h"
#include "hw/array/pixel_array.h"
#include "hw/array/sequencer.h"
#include "hw/systemc/array_view.h"
#include "hw/systemc/kernel.h"
#include "tests/kinds/figures.h"
#include "tests/kinds/raster.h"

namespace csgsim::raster {

namespace {

/// Executes instructions on all pixels at once: their meaning, independent of the processor's timing.
class Meaning {
 public:
  explicit Meaning(const isa::ArrayShape& shape) : trees_({shape.width, shape.height}), pixels_(shape, 1) {}

  void begin(const isa::Region& region) { pixels_.reset(region.width, region.height); }

  void carry_out(const isa::Instruction& instruction) {
    sequencer_.begin(instruction);
    std::deque<array::ArrayStep> on_their_way(trees_.latency());
    while (sequencer_.busy()) step(sequencer_.issue(), on_their_way);
    for (unsigned i = 0; i < trees_.latency(); ++i) step({}, on_their_way);
  }

  [[nodiscard]] const array::PixelArray& pixels() const { return pixels_; }

 private:
  void step(const array::BitStep& step, std::deque<array::ArrayStep>& on_their_way) {
    on_their_way.push_back(step.pixels);
    if (trees_.latency() == 0) trees_.clock(step.root, leaves_);
    pixels_.step(on_their_way.front(), leaves_);
    on_their_way.pop_front();
    if (trees_.latency() > 0) trees_.clock(step.root, leaves_);
  }

  array::Sequencer sequencer_{1, 1, 1};
  array::LinearEvaluator trees_;
  array::StreamBit leaves_;
  array::PixelArray pixels_;
};

class Processor final : public sc_core::sc_module, public systemc::ClockedMachine {
 public:
  Processor(sc_core::sc_module_name name, const machines::Machine& machine)
      : sc_core::sc_module(name),
        pixel_clocks_(machines::kind_figures<Figures>(machine).pixel_clocks),
        clock_("clock", systemc::period_of(machine), 0.5, systemc::period_of(machine)),
        meaning_(machine.array) {
    SC_HAS_PROCESS(Processor);
    SC_THREAD(work);
  }

  systemc::RunReport run(const isa::Program& program, systemc::RunListener& listener) override {
    program_ = &program;
    listener_ = &listener;
    clocks_ = 0;
    if (sc_core::sc_get_status() == sc_core::SC_ELABORATION) sc_core::sc_start(sc_core::SC_ZERO_TIME);
    start_.notify(sc_core::SC_ZERO_TIME);
    sc_core::sc_start();
    systemc::RunReport report{.clocks = clocks_, .answers = {}};
    report.account.parts = {{"processor", {{"working", clocks_}}}};
    return report;
  }

 private:
  void work() {
    while (true) {
      wait(start_);
      for (std::uint32_t s = 0; s < program_->segments.size(); ++s) draw(s);
      sc_core::sc_pause();
    }
  }

  void draw(std::uint32_t number) {
    const isa::Segment& segment = program_->segments[number];
    meaning_.begin(segment.region);
    for (std::uint32_t i = 0; i < segment.instructions.size(); ++i) {
      const std::uint64_t enabled = meaning_.pixels().count_enabled();
      const std::uint64_t before = clocks_;
      const array::PlaneShape shape = meaning_.pixels().shape();
      for (std::uint64_t pixel = 0; pixel < std::uint64_t{shape.width} * shape.height; ++pixel) spend();
      meaning_.carry_out(segment.instructions[i]);
      listener_->after_instruction({number, i, clocks_ - before, enabled, 0}, systemc::ArrayView(meaning_.pixels()));
    }
    listener_->after_segment(number, systemc::ArrayView(meaning_.pixels()));
  }

  void spend() {
    for (std::uint32_t i = 0; i < pixel_clocks_; ++i) {
      wait(clock_.posedge_event());
      ++clocks_;
    }
  }

  const std::uint32_t pixel_clocks_;
  sc_core::sc_clock clock_;
  Meaning meaning_;
  const isa::Program* program_ = nullptr;
  systemc::RunListener* listener_ = nullptr;
  std::uint64_t clocks_ = 0;
  sc_core::sc_event start_{"start"};
};

}  // namespace

std::unique_ptr<systemc::ClockedMachine> make_machine(const machines::Machine& machine) {
  return std::make_unique<Processor>("processor", machine);
}

}  // namespace csgsim::raster
