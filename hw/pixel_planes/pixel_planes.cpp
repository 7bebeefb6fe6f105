#include "hw/pixel_planes/pixel_planes.h"

#include <sysc/tracing/sc_tracing_ids.h>

#include <string_view>
#include <utility>

#include "hw/base/error.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/make.h"
#include "hw/pixel_planes/timing.h"
#include "hw/systemc/fit.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_planes {

namespace {

array::PlaneShape plane_shape(const machines::Machine& machine) { return {machine.array.width, machine.array.height}; }

ControllerFigures controller_figures(const machines::Machine& machine) {
  return {.link_width = machine.link.width,
          .latency = machines::evaluator_latency(machine.array),
          .memory_bits = machine.array.memory_bits,
          .clear_clocks = machine.clear_clocks};
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
      wave_("wave", {clock_, controller_, processors_, root_, control_at_pixels_, answer_}, machine.alu_bits) {
  SC_HAS_PROCESS(PixelPlanes);
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);

  host_.clock(clock_);
  host_.words(link_);
  host_.requests(requests_);

  controller_.clock(clock_);
  controller_.link(link_);
  controller_.requests(requests_);
  controller_.refreshes(refreshes_);
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
  scan_out_.refresh(processors_.refresh);
  scan_out_.control(control_at_pixels_);
  scan_out_.refreshes(refreshes_);
  scan_out_.video(video_);
  scan_out_.latched(latched_);
  scan_out_.frames(frames_);

  SC_METHOD(on_done);
  dont_initialize();
  sensitive << programs_ << latched_ << frames_;
}

/// Gives control back to who started the simulation, when all that belongs to this edge has happened.
void PixelPlanes::on_done() { sc_core::sc_pause(); }

void PixelPlanes::elaborate() {
  if (sc_core::sc_get_status() == sc_core::SC_ELABORATION) sc_core::sc_start(sc_core::SC_ZERO_TIME);
}

/// Clock edges since the machine was built.
std::uint64_t PixelPlanes::edges() const { return sc_core::sc_time_stamp().value() / clock_.period().value(); }

template <class Condition>
void PixelPlanes::run_until(const Condition& holds) {
  while (!holds()) sc_core::sc_start();
}

kernel::RunReport PixelPlanes::run(const isa::Program& program, kernel::RunListener& listener) {
  kernel::RunListener* const listeners[] = {&listener};
  return std::move(run_sequence({&program, 1}, listeners).front());
}

std::vector<kernel::RunReport> PixelPlanes::run_sequence(std::span<const isa::Program> programs,
                                                         std::span<kernel::RunListener* const> listeners) {
  const array::PlaneShape shape = processors_.pixels().shape();
  for (const isa::Program& program : programs)
    kernel::check_fits(program.shape, {shape.width, shape.height, processors_.pixels().memory_bits()});
  elaborate();
  std::vector<kernel::RunReport> reports;
  std::uint64_t begun = 0;
  const isa::Program* on_screen = nullptr;  // whose picture is being shown, if one is
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const std::uint64_t now = edges();
    if (i > 0) reports.back().interval_clocks = now - begun;
    begun = now;
    reports.push_back(draw(programs[i], *listeners[i]));
    run_until([this] { return !scan_out_.busy(); });
    if (on_screen != nullptr) show(*on_screen, reports[i - 1]);
    const isa::Field colour = isa::field_of(programs[i], isa::FieldRole::colour);
    on_screen = colour.width > 0 ? &programs[i] : nullptr;
    if (on_screen == nullptr) continue;
    scan_out_.begin(colour);
    run_until([this] { return scan_out_.has_latched(); });
  }
  run_until([this] { return !scan_out_.busy(); });
  if (on_screen != nullptr) {
    kernel::RunReport& last = reports.back();
    show(*on_screen, last);
    last.interval_clocks = interval_clocks(last.clocks, scan_out_.clocks(), scan_out_.latch_clocks());
  }
  return reports;
}

kernel::RunReport PixelPlanes::draw(const isa::Program& program, kernel::RunListener& listener) {
  const std::optional<WaveRequest> wave = std::exchange(wave_request_, std::nullopt);
  retirement_.begin(listener);
  completion_.begin(program.segments);
  host_.load(link::frame_words(program, machine_.link.width));
  controller_.begin();
  if (wave) wave_.arm(*wave, program.segments);
  const bool recorded = clock_program(wave);
  retirement_.rethrow();
  kernel::RunReport report{
      .clocks = controller_.clocks(),
      .latency_clocks = latency_,
      .skipped = completion_.skipped(),
      .answers = completion_.answers(),
      .account = account(controller_.account(), host_.account(), machine_.link, controller_.instructions())};
  report.recorded = recorded;
  return report;
}

/// What the scan-out has shown of that Program.
void PixelPlanes::show(const isa::Program& program, kernel::RunReport& report) {
  report.shown_clocks = report.clocks + scan_out_.clocks();
  if (fills_array(program, processors_.pixels().shape())) report.picture = scan_out_.picture();
}

/// Says whether the window that is to be recorded has been reached.
bool PixelPlanes::clock_program(const std::optional<WaveRequest>& wave) {
  try {
    run_until([this] { return controller_.idle(); });
  } catch (const sc_core::sc_report& report) {
    if (!wave || std::string_view(report.get_msg_type()) != sc_core::SC_ID_TRACING_FOPEN_FAILED_) throw;
    throw InputError(wave->file.native() +
                     ": SystemC cannot open it for the waveform; allow more open files (ulimit -n), or check " +
                     "the folder's permissions");
  }
  return wave_.finish();
}

void PixelPlanes::record(const WaveRequest& request) {
  check(request, processors_.pixels());
  wave_request_ = request;
}

ShownFrame PixelPlanes::scan_out(isa::Field colour) {
  elaborate();
  scan_out_.begin(colour);
  run_until([this] { return !scan_out_.busy(); });
  return {.clocks = scan_out_.clocks(), .latch_clocks = scan_out_.latch_clocks(), .colours = scan_out_.picture()};
}

std::unique_ptr<kernel::ClockedMachine> make_machine(const machines::Machine& machine) {
  return std::make_unique<PixelPlanes>("pixel_planes", machine);
}

}  // namespace csgsim::pixel_planes
