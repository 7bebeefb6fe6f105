#include <sysc/tracing/sc_tracing_ids.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <systemc>
#include <utility>

#include "hw/base/error.h"
#include "hw/machines/runs_on.h"
#include "hw/pixel_planes/pixel_planes.h"
#include "sim/cycle/array_state.h"
#include "sim/cycle/fit.h"
#include "sim/cycle/kinds.h"
#include "sim/cycle/overflow.h"
#include "sim/cycle/record.h"

namespace csgsim::sim {

namespace {

using pixel_planes::PixelPlanes;

/// Passes what the machine tells on to the observers, and counts the overflows, which the machine does not notice.
class Relay final : public pixel_planes::RunListener {
 public:
  Relay(const isa::Program& program, const array::PixelArray& pixels, std::span<Observer* const> observers)
      : program_(program), pixels_(pixels), observers_(observers) {}

  void after_instruction(const pixel_planes::Retired& retired) override {
    const isa::Segment& segment = program_.segments[retired.segment];
    const ArrayState state(pixels_, segment.region);
    const Step step{.segment = retired.segment,
                    .index = retired.index,
                    .instruction = segment.instructions[retired.index],
                    .clocks = retired.clocks,
                    .enabled_pixels = retired.enabled_pixels};
    for (Observer* observer : observers_) observer->after_instruction(step, state);
    const std::uint64_t next = retired.index + 1 + retired.skipped;
    if (next < segment.instructions.size()) before_instruction(segment, next);
  }

  void after_segment(std::uint32_t segment) override {
    const ArrayState state(pixels_, program_.segments[segment].region);
    for (Observer* observer : observers_) observer->after_segment(segment, state);
  }

  [[nodiscard]] std::uint64_t overflows() const { return overflows_; }

 private:
  /// A segment's first instruction finds no pixel enabled.
  void before_instruction(const isa::Segment& segment, std::uint64_t index) {
    overflows_ += count_overflows(segment.instructions[index].linear, segment.region, pixels_.enable(),
                                  pixels_.shape().row_words());
  }

  const isa::Program& program_;
  const array::PixelArray& pixels_;
  std::span<Observer* const> observers_;
  std::uint64_t overflows_ = 0;
};

/// The array holds the whole picture when the program is through.
bool fills_array(const isa::Program& program, array::PlaneShape shape) {
  const isa::Region whole{0, 0, shape.width, shape.height};
  return program.segments.size() == 1 && program.segments.front().region == whole;
}

RecordedRun run_on(PixelPlanes& hardware, const machines::Machine& machine, const isa::Program& program,
                   std::span<Observer* const> observers) {
  machines::check_runs_on(program, machine);
  const array::PixelArray& pixels = hardware.processors().pixels();
  check_fits(program.shape, {pixels.shape().width, pixels.shape().height, pixels.memory_bits()});
  Relay relay(program, pixels, observers);
  pixel_planes::RunReport report = hardware.run(program.segments, relay);
  RecordedRun run{.result = {.clocks = report.clocks,
                             .latency_clocks = report.latency_clocks,
                             .overflows = relay.overflows(),
                             .skipped = report.skipped,
                             .answers = std::move(report.answers)},
                  .window_reached = report.recorded};
  if (const isa::Field colour = isa::field_of(program, isa::FieldRole::colour); colour.width > 0) {
    pixel_planes::Frame frame = hardware.scan_out(colour);
    run.result.scan_out_clocks = frame.clocks;
    if (fills_array(program, pixels.shape())) run.result.scanned_out = std::move(frame.colours);
  }
  return run;
}

class PixelPlanesEngine final : public Engine {
 public:
  PixelPlanesEngine(machines::Machine machine, PixelPlanes& hardware)
      : machine_(std::move(machine)), hardware_(hardware) {}

  [[nodiscard]] std::string_view level() const override { return "cycle"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    return run_on(hardware_, machine_, program, observers).result;
  }

 private:
  machines::Machine machine_;
  PixelPlanes& hardware_;
};

PixelPlanes& hardware_of(const machines::Machine& machine) {
  static const std::unique_ptr<PixelPlanes> hardware = std::make_unique<PixelPlanes>("pixel_planes", machine);
  return *hardware;
}

}  // namespace

std::unique_ptr<Engine> make_pixel_planes_engine(const machines::Machine& machine) {
  claim_elaboration(machine);
  return std::make_unique<PixelPlanesEngine>(machine, hardware_of(machine));
}

RecordedRun run_and_record(const machines::Machine& machine, const isa::Program& program,
                           std::span<Observer* const> observers, const pixel_planes::WaveRequest& request) {
  if (machine.kind != machines::Kind::frame_buffer) {
    throw InputError("waves show machines of the kind " + std::string(name_of(machines::Kind::frame_buffer)) +
                     ", and " + machine.name + " is of the kind " + std::string(name_of(machine.kind)) +
                     "; take another --machine");
  }
  claim_elaboration(machine);
  PixelPlanes& hardware = hardware_of(machine);
  hardware.record(request);
  try {
    return run_on(hardware, machine, program, observers);
  } catch (const sc_core::sc_report& report) {
    if (std::string_view(report.get_msg_type()) != sc_core::SC_ID_TRACING_FOPEN_FAILED_) throw;
    throw InputError(request.file.native() + ": SystemC cannot open it for the waveform; allow more open files " +
                     "(ulimit -n), or check the folder's permissions");
  }
}

}  // namespace csgsim::sim
