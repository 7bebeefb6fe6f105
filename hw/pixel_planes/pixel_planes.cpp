#include "hw/pixel_planes/pixel_planes.h"

#include <utility>

#include "hw/machines/clocks.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_planes {

namespace {

constexpr int link_words = 16;  ///< of the host link's FIFO: more than the controller takes in a clock

array::PlaneShape plane_shape(const machines::Machine& machine) { return {machine.array.width, machine.array.height}; }

}  // namespace

PixelPlanes::PixelPlanes(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      latency_(machines::evaluator_latency(machine.array)),
      clock_("clock", kernel::period_of(machine), 0.5, kernel::period_of(machine)),
      link_("link", link_words),
      tree_bits_("tree_bits", plane_shape(machine)),
      accounts_("accounts", static_cast<int>(latency_) + 2),
      controller_("controller", array::Sequencer(machine.memory_reads, machine.alu_bits), latency_),
      control_delay_("control_delay", latency_),
      evaluator_("evaluator", plane_shape(machine)),
      processors_("processors", machine.array, machine.alu_bits),
      scan_out_("scan_out", plane_shape(machine)),
      wave_("wave", {clock_, controller_, processors_, root_, control_at_pixels_, answer_}, machine.alu_bits) {
  SC_HAS_PROCESS(PixelPlanes);
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);

  host_.link(link_);
  host_.jumps(jumps_);

  controller_.clock(clock_);
  controller_.link(link_);
  controller_.jumps(jumps_);
  controller_.answer(answer_);
  controller_.root(root_);
  controller_.control(control_);
  controller_.accounts(accounts_);
  controller_.programs(programs_);

  control_delay_.clock(clock_);
  control_delay_.in(control_);
  control_delay_.out(control_at_pixels_);
  control_delay_.question(question_);

  evaluator_.clock(clock_);
  evaluator_.root(root_);
  evaluator_.leaves(tree_bits_);

  processors_.clock(clock_);
  processors_.control(control_at_pixels_);
  processors_.tree(tree_bits_);
  processors_.retired(retired_);

  global_or_.question(question_);
  global_or_.enable(processors_.enable_lines);
  global_or_.answer(answer_);

  retirement_.retired(retired_);
  retirement_.accounts(accounts_);
  retirement_.enable(processors_.enable_lines);

  scan_out_.clock(clock_);
  scan_out_.refresh(processors_.refresh);
  scan_out_.video(video_);
  scan_out_.frames(frames_);

  SC_METHOD(on_done);
  dont_initialize();
  sensitive << programs_ << frames_;
}

/// Gives control back to who started the simulation, when all that belongs to this edge has happened.
void PixelPlanes::on_done() { sc_core::sc_pause(); }

void PixelPlanes::elaborate() {
  if (sc_core::sc_get_status() == sc_core::SC_ELABORATION) sc_core::sc_start(sc_core::SC_ZERO_TIME);
}

RunReport PixelPlanes::run(std::span<const isa::Segment> segments, RunListener& listener) {
  elaborate();
  retirement_.begin(segments, listener);
  host_.send(segments);
  if (wave_request_) wave_.arm(*std::exchange(wave_request_, std::nullopt));
  sc_core::sc_start();
  const bool recorded = wave_.finish();
  retirement_.rethrow();
  return {.clocks = controller_.clocks(),
          .latency_clocks = latency_,
          .skipped = retirement_.skipped(),
          .answers = retirement_.answers(),
          .recorded = recorded};
}

void PixelPlanes::record(WaveRequest request) {
  check(request, processors_.pixels());
  wave_request_ = std::move(request);
}

Frame PixelPlanes::scan_out(isa::Field colour) {
  elaborate();
  scan_out_.begin(colour);
  sc_core::sc_start();
  return {.clocks = scan_out_.clocks(), .colours = scan_out_.picture()};
}

}  // namespace csgsim::pixel_planes
