#include "hw/pixel_planes/pixel_planes.h"

#include <sysc/tracing/sc_tracing_ids.h>

#include <string>
#include <string_view>
#include <utility>

#include "hw/base/error.h"
#include "hw/machines/clocks.h"
#include "hw/machines/timing.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/make.h"
#include "hw/systemc/fit.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_planes {

namespace {

array::PlaneShape plane_shape(const machines::Machine& machine) { return {machine.array.width, machine.array.height}; }

ControllerFigures controller_figures(const machines::Machine& machine) {
  return {.link_width = machine.link.width,
          .latency = machines::evaluator_latency(machine.array),
          .memory_bits = machine.array.memory_bits,
          .clear_clocks = machine.clear_clocks,
          .two_buffers = machines::own<Figures>(machine).scan_out_buffers >= 2};
}

/// The array holds the whole picture when the program is through.
bool fills_array(const isa::Program& program, array::PlaneShape shape) {
  const isa::Region whole{0, 0, shape.width, shape.height};
  return program.segments.size() == 1 && program.segments.front().region == whole;
}

}  // namespace

PixelPlanes::PixelPlanes(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      machine_(machine),
      latency_(machines::evaluator_latency(machine.array)),
      clock_("clock", kernel::period_of(machine), 0.5, kernel::period_of(machine)),
      link_("link", static_cast<int>(machine.link.fifo_depth)),
      tree_bits_("tree_bits", plane_shape(machine)),
      accounts_("accounts", static_cast<int>(latency_) + 2),
      host_("host", machine.link),
      controller_("controller", array::Sequencer(machine.memory_reads, machine.alu_bits), controller_figures(machine)),
      control_delay_("control_delay", latency_),
      evaluator_("evaluator", plane_shape(machine)),
      processors_("processors", machine.array, machine.alu_bits),
      global_or_("global_or", plane_shape(machine), machines::own<Figures>(machine).or_fan_in),
      scan_out_("scan_out", plane_shape(machine), machines::own<Figures>(machine).scan_out_pixels,
                machines::own<Figures>(machine).scan_out_port),
      wave_("wave",
            {clock_, controller_, processors_, root_, control_at_pixels_, answer_, refreshes_, pictures_, latched_,
             video_},
            machine.alu_bits) {
  SC_HAS_PROCESS(PixelPlanes);
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);

  host_.clock(clock_);
  host_.words(link_);
  host_.requests(requests_);

  controller_.clock(clock_);
  controller_.link(link_);
  controller_.requests(requests_);
  controller_.frames(waiting_frames_);
  controller_.refreshes(refreshes_);
  controller_.latched(latched_);
  controller_.pictures(pictures_);
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

  global_or_.clock(clock_);
  global_or_.question(question_);
  global_or_.enable(processors_.enable_lines);
  global_or_.answer(answer_);

  completion_.retired(retired_);
  completion_.accounts(accounts_);
  completion_.enable(processors_.enable_lines);
  completion_.retirement(retirement_);

  scan_out_.clock(clock_);
  scan_out_.pictures(pictures_);
  scan_out_.refresh(processors_.refresh);
  scan_out_.control(control_at_pixels_);
  scan_out_.refreshes(refreshes_);
  scan_out_.video(video_);
  scan_out_.latched(latched_);
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

/// Clock edges since the machine was built.
std::uint64_t PixelPlanes::edges() const { return sc_core::sc_time_stamp().value() / clock_.period().value(); }

/// What the scan-out has come to the end of belongs to the oldest frame that is being shown.
void PixelPlanes::collect() {
  if (std::exchange(shown_, frames_.read()) == frames_.read()) return;
  const Showing& one = showing_.front();
  one.report->shown_clocks = edges() - one.begun;
  if (one.fills_array) one.report->picture = scan_out_.picture();
  showing_.pop_front();
}

void PixelPlanes::run_until_shown() {
  while (!showing_.empty()) {
    sc_core::sc_start();
    collect();
  }
}

void PixelPlanes::check(std::span<const isa::Program> programs) const {
  const array::PlaneShape shape = processors_.pixels().shape();
  const isa::Field first = isa::frame_header(programs.front()).colour;
  for (const isa::Program& program : programs) {
    kernel::check_fits(program.shape, {shape.width, shape.height, processors_.pixels().memory_bits()});
    const isa::Field colour = isa::frame_header(program).colour;
    if (machines::own<Figures>(machine_).scan_out_buffers < 2 || colour.width == first.width) continue;
    throw InputError("frames with colours of " + std::to_string(first.width) + " and " + std::to_string(colour.width) +
                     " bits follow each other on a machine of two buffers; compile all with the same --colour-bits");
  }
}

kernel::RunReport PixelPlanes::run(const isa::Program& program, kernel::RunListener& listener) {
  kernel::RunListener* const listeners[] = {&listener};
  return std::move(run_sequence({&program, 1}, listeners).front());
}

std::vector<kernel::RunReport> PixelPlanes::run_sequence(std::span<const isa::Program> programs,
                                                         std::span<kernel::RunListener* const> listeners) {
  std::vector<kernel::RunReport> reports(programs.size());
  if (programs.empty()) return reports;
  check(programs);
  elaborate();
  const std::optional<WaveRequest> wave = std::exchange(wave_request_, std::nullopt);
  if (wave) wave_.arm(*wave, programs.front().segments);
  try {
    for (std::size_t i = 0; i < programs.size(); ++i) {
      const std::uint64_t begun = begun_;
      draw(programs[i], *listeners[i], reports[i]);
      if (i > 0) reports[i - 1].interval_clocks = begun_ - begun;
      if (i + 1 < programs.size()) reports[i].recorded = wave_.finish();
    }
    run_until_shown();
  } catch (const sc_core::sc_report& report) {
    if (!wave || std::string_view(report.get_msg_type()) != sc_core::SC_ID_TRACING_FOPEN_FAILED_) throw;
    throw InputError(wave->file.native() +
                     ": SystemC cannot open it for the waveform; allow more open files (ulimit -n), or check " +
                     "the folder's permissions");
  }
  reports.back().recorded = wave_.finish();
  reports.back().interval_clocks = machines::time_frame(programs.back(), machine_, completion_.skips()).interval_clocks;
  return reports;
}

void PixelPlanes::draw(const isa::Program& program, kernel::RunListener& listener, kernel::RunReport& report) {
  retirement_.begin(listener);
  completion_.begin(program.segments);
  host_.load(link::frame_words(program, machine_.link.width));
  waiting_frames_.nb_write(true);
  while (drawn_ == programs_.read()) {
    sc_core::sc_start();
    collect();
  }
  drawn_ = programs_.read();
  begun_ = edges() - controller_.clocks();
  report.clocks = controller_.clocks();
  report.latency_clocks = latency_;
  report.skipped = completion_.skipped();
  report.answers = completion_.answers();
  report.account = account(controller_.account(), host_.account(), machine_, controller_.instructions());
  if (isa::frame_header(program).colour.width > 0)
    showing_.push_back({begun_, fills_array(program, processors_.pixels().shape()), &report});
  try {
    retirement_.rethrow();
  } catch (...) {
    run_until_shown();
    wave_.finish();
    throw;
  }
}

void PixelPlanes::record(const WaveRequest& request) {
  pixel_planes::check(request, processors_.pixels());
  wave_request_ = request;
}

std::unique_ptr<kernel::ClockedMachine> make_machine(const machines::Machine& machine) {
  return std::make_unique<PixelPlanes>("pixel_planes", machine);
}

}  // namespace csgsim::pixel_planes
