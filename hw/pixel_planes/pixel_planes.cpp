#include "hw/pixel_planes/pixel_planes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "hw/base/error.h"
#include "hw/machines/clocks.h"
#include "hw/machines/timing.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/kind.h"
#include "hw/pixel_planes/probed.h"
#include "hw/pixel_planes/taps.h"
#include "hw/systemc/kernel.h"
#include "hw/systemc/maker.h"
#include "hw/wave/instruction_taps.h"

namespace csgsim::pixel_planes {

namespace {

array::PlaneShape plane_shape(const machines::Machine& machine) { return {machine.array.width, machine.array.height}; }

array::Sequencer sequencer(const machines::Machine& machine) {
  return {machine.memory_reads, machine.alu_bits, machine.evaluator_bits};
}

ControllerFigures controller_figures(const machines::Machine& machine) {
  return {.link_width = machine.link.width,
          .latency = machines::evaluator_latency(machine),
          .memory_bits = machine.array.memory_bits,
          .clear_clocks = machine.clear_clocks,
          .two_buffers = machines::kind_figures<Figures>(machine).scan_out_buffers >= 2};
}

array::TreeForm tree_form(const machines::Machine& machine) {
  return {machine.evaluator_degree, machine.evaluator_bits, machine.register_levels};
}

/// Whether the array holds the whole picture after the Program.
bool fills_array(const isa::Program& program, array::PlaneShape shape) {
  const isa::Region whole{0, 0, shape.width, shape.height};
  return program.segments.size() == 1 && program.segments.front().region == whole;
}

/// Throws InputError unless the machine has enough pixels and memory bits for the Program.
void check_fits(const isa::ArrayShape& program, const isa::ArrayShape& machine) {
  if (program.width <= machine.width && program.height <= machine.height &&
      program.memory_bits <= machine.memory_bits) {
    return;
  }
  const auto text = [](const isa::ArrayShape& shape) {
    return std::to_string(shape.width) + "x" + std::to_string(shape.height) + " pixels of " +
           std::to_string(shape.memory_bits) + " bits";
  };
  throw InputError("the Program is for " + text(program) + ", the machine has " + text(machine) +
                   "; compile it for this machine");
}

}  // namespace

PixelPlanes::PixelPlanes(sc_core::sc_module_name name, const machines::Machine& machine, systemc::EvaluatorForm form,
                         const systemc::EarlierRun* earlier)
    : sc_core::sc_module(name),
      machine_(machine),
      earlier_(earlier == nullptr ? std::nullopt : std::optional(*earlier)),
      latency_(machines::evaluator_latency(machine)),
      clock_("clock", systemc::period_of(machine)),
      link_("link", static_cast<int>(machine.link.fifo_depth)),
      accounts_("accounts", static_cast<int>(latency_) + 2),
      host_("host", systemc::period_of(machine), machine.link),
      controller_("controller", systemc::period_of(machine), sequencer(machine), controller_figures(machine)),
      pipeline_("pipeline", machine, form, earlier),
      global_or_("global_or", plane_shape(machine), machines::kind_figures<Figures>(machine).or_fan_in),
      scan_out_("scan_out", systemc::period_of(machine), plane_shape(machine),
                machines::kind_figures<Figures>(machine).scan_out_pixels,
                machines::kind_figures<Figures>(machine).scan_out_port) {
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
  controller_.wires(pipeline_);
  controller_.accounts(accounts_);
  controller_.programs(programs_);

  pipeline_.question(question_);
  pipeline_.retired(retired_);

  global_or_.clock(clock_);
  global_or_.question(question_);
  global_or_.enable(pipeline_);
  global_or_.answer(answer_);

  completion_.retired(retired_);
  completion_.accounts(accounts_);
  completion_.enable(pipeline_);
  completion_.retirement(retirement_);

  scan_out_.clock(clock_);
  scan_out_.pictures(pictures_);
  scan_out_.refresh(pipeline_);
  scan_out_.refreshes(refreshes_);
  scan_out_.latched(latched_);
  scan_out_.frames(frames_);

  SC_METHOD(on_done);
  dont_initialize();
  sensitive << programs_ << frames_;
}

/// Returns control to the caller of the simulation after all processes at this edge have run.
void PixelPlanes::on_done() { sc_core::sc_pause(); }

/// Clock edges since construction.
std::uint64_t PixelPlanes::edges() const { return systemc::edges(clock_.period()); }

/// Assigns a picture that the scan-out has completed to the oldest frame being shown.
void PixelPlanes::collect() {
  if (std::exchange(shown_, frames_.read()) == frames_.read()) return;
  const Showing& one = showing_.front();
  one.report->shown_clocks = edges() - one.begun;
  if (one.fills_array) one.report->picture = scan_out_.picture();
  showing_.pop_front();
}

void PixelPlanes::run_until_shown() {
  while (!showing_.empty() && !systemc::is_stopped()) {
    systemc::run();
    collect();
  }
}

void PixelPlanes::check_programs(std::span<const isa::Program> programs) const {
  const array::PlaneShape shape = plane_shape(machine_);
  const isa::Field first = isa::frame_header(programs.front()).colour;
  for (const isa::Program& program : programs) {
    check_fits(program.shape, {shape.width, shape.height, pipeline_.pixels().memory_bits()});
    const isa::Field colour = isa::frame_header(program).colour;
    if (machines::kind_figures<Figures>(machine_).scan_out_buffers < 2 || colour.width == first.width) continue;
    throw InputError("a machine with two buffers cannot draw frames with colours of " + std::to_string(first.width) +
                     " and " + std::to_string(colour.width) +
                     " bits in sequence; compile all with the same --colour-bits");
  }
}

systemc::RunReport PixelPlanes::run(const isa::Program& program, systemc::RunListener& listener) {
  systemc::RunListener* const listeners[] = {&listener};
  return std::move(run_sequence({&program, 1}, listeners).front());
}

std::vector<systemc::RunReport> PixelPlanes::run_sequence(std::span<const isa::Program> programs,
                                                          std::span<systemc::RunListener* const> listeners) {
  std::vector<systemc::RunReport> reports(programs.size());
  if (programs.empty()) return reports;
  check_programs(programs);
  systemc::elaborate();
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const std::uint64_t begun = begun_;
    draw_frame(programs[i], *listeners[i], reports[i]);
    if (i > 0) reports[i - 1].interval_clocks = begun_ - begun;
  }
  run_until_shown();
  if (systemc::is_stopped()) return reports;
  reports.back().interval_clocks = machines::time_frame(programs.back(), machine_, completion_.skips()).interval_clocks;
  return reports;
}

void PixelPlanes::draw_frame(const isa::Program& program, systemc::RunListener& listener, systemc::RunReport& report) {
  retirement_.begin(listener);
  completion_.begin(program.segments);
  start_frame(program);
  while (drawn_ == programs_.read() && !systemc::is_stopped()) {
    systemc::run();
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
    showing_.push_back({begun_, fills_array(program, plane_shape(machine_)), &report});
  try {
    retirement_.rethrow();
  } catch (...) {
    run_until_shown();
    throw;
  }
}

void PixelPlanes::start_frame(const isa::Program& program) {
  if (earlier_) pipeline_.show(displayed_field(program, machine_));
  if (start_) return resume(program, *std::exchange(start_, std::nullopt));
  if (earlier_) global_or_.set_test_results(earlier_->answers);
  host_.load(link::frame_words(program, machine_.link.width));
  waiting_frames_.nb_write(true);
}

/// Starts at an instruction with idle wires between controller and pixels. The words that the whole machine would have
/// there have passed before the window begins.
void PixelPlanes::resume(const isa::Program& program, const Start& start) {
  const array::PixelReplay fresh(earlier_->pixels, machine_.array.memory_bits, sequencer(machine_), machine_.alu_bits);
  const array::PixelReplay replay = replay_until(program, earlier_->answers, start, fresh);
  pipeline_.resume(replay.pixels(), replay.tree());
  const auto first = static_cast<std::ptrdiff_t>(start.tests_before);
  global_or_.set_test_results({earlier_->answers.begin() + first, earlier_->answers.end()});
  link::FrameWords words = link::frame_words(program, machine_.link.width, start.ordinal + 1, start.end);
  for (std::size_t i = start.moment.words_read; i < start.moment.words_sent; ++i) link_.nb_write(words.words[i]);
  host_.resume(std::move(words), start.moment.words_sent, start.moment.clocks_left);
  completion_.resume(start.segment, start.index);
  controller_.resume(program.segments[start.segment].instructions[start.index], start.ordinal, start.moment.clock);
}

std::uint64_t PixelPlanes::skip_to(const isa::Program& program, wave::Window window) {
  if (!earlier_) return 0;
  start_ = find_start_before(program, machine_, *earlier_, window);
  return start_ ? start_->moment.clock : 0;
}

std::vector<wave::Tap> PixelPlanes::taps(const isa::Program& program, const wave::Request& request) const {
  std::vector<wave::Tap> taps = host_taps();
  const auto add = [&](std::vector<wave::Tap> more) { wave::add(std::move(more), taps); };
  const array::TreeForm trees = tree_form(machine_);
  add(controller_taps(program));
  add(root_taps("root", pipeline_, trees));
  add(control_taps("pixels", pipeline_, trees.bits, program,
                   [this] { return wave::Number(pipeline_.now().at_pixels().ordinal); }));
  taps.push_back(wave::bit("answer.valid", [this] { return answer_.read().valid; }));
  taps.push_back(wave::bit("answer.any_enabled", [this] {
    return answer_.read().valid ? wave::Number(answer_.read().any_enabled) : std::nullopt;
  }));
  add(scan_out_taps());
  for (std::size_t i = 0; i < request.pixels.size(); ++i) {
    const array::Place place = position_in_array(request.pixels[i], program);
    const array::Place built = earlier_ ? array::Place{simulated_pixel_index(*earlier_, place), 0} : place;
    add(pixel_taps(request.pixels[i], {pipeline_, place, built, nullptr, trees}, program, request.tree_levels,
                   machine_.alu_bits));
  }
  return taps;
}

std::vector<wave::Tap> PixelPlanes::host_taps() const {
  return {wave::text("host.state", [this] { return std::string(host_.state()); }),
          wave::number("host.word", 32, [this] { return wave::Number(host_.word()); }),
          wave::number("link.fill", 16,
                       [this] { return wave::Number(static_cast<std::uint64_t>(link_.num_available())); })};
}

std::vector<wave::Tap> PixelPlanes::controller_taps(const isa::Program& program) const {
  const auto at = [this] {
    const ControllerStatus status = controller_.status();
    return status.busy ? wave::Number(status.ordinal) : std::nullopt;
  };
  std::vector<wave::Tap> taps = wave::instruction_taps("controller", program, at);
  taps.push_back(wave::text("controller.state", [this] { return std::string(controller_.state()); }));
  const auto of_status = [&](const char* name, unsigned width, auto read) {
    taps.push_back(wave::number(name, width, [this, read] {
      const ControllerStatus status = controller_.status();
      return status.busy ? wave::Number(read(status)) : std::nullopt;
    }));
  };
  of_status("controller.bit", 8, [](const ControllerStatus& status) { return status.bit; });
  of_status("controller.pass", 2, [](const ControllerStatus& status) { return status.pass; });
  return taps;
}

std::vector<wave::Tap> PixelPlanes::scan_out_taps() const {
  const auto shown = [this](std::uint64_t value) {
    return scan_out_.is_showing() ? wave::Number(value) : std::nullopt;
  };
  return {
      wave::text("scan_out.state", [this] { return std::string(scan_out_.is_showing() ? "showing" : ""); }),
      wave::number("scan_out.refreshes_asked", 2,
                   [this] { return wave::Number(static_cast<std::uint64_t>(refreshes_.num_available())); }),
      wave::bit("scan_out.picture_finished", [this] { return wave::Number(pictures_.num_available() > 0 ? 1 : 0); }),
      wave::bit("scan_out.picture_latched", [this] { return wave::Number(latched_.num_available() > 0 ? 1 : 0); }),
      wave::number("scan_out.row", 16, [this, shown] { return shown(scan_out_.row_latched()); }),
      wave::hexadecimal("scan_out.video", 24, [this, shown] { return shown(scan_out_.video()); })};
}

}  // namespace csgsim::pixel_planes

namespace csgsim::systemc {

extern const Maker pixel_planes_maker{
    .kind = &pixel_planes::kind,
    .make = [](const machines::Machine& machine) -> std::unique_ptr<ClockedMachine> {
      return std::make_unique<pixel_planes::PixelPlanes>("pixel_planes", machine);
    },
    .make_stepped = [](const machines::Machine& machine) -> std::unique_ptr<ClockedMachine> {
      return std::make_unique<pixel_planes::PixelPlanes>("pixel_planes", machine, EvaluatorForm::stepped);
    },
    .make_probed = [](const machines::Machine& machine, const EarlierRun& earlier,
                      EvaluatorForm form) -> std::unique_ptr<ClockedMachine> {
      return std::make_unique<pixel_planes::PixelPlanes>("pixel_planes", machine, form, &earlier);
    }};

}  // namespace csgsim::systemc
