#include "sim/waves/record.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "hw/base/error.h"
#include "hw/kinds/make.h"
#include "hw/machines/kind.h"
#include "hw/systemc/kernel.h"
#include "hw/systemc/run_listener.h"
#include "hw/systemc/wave_recorder.h"
#include "hw/wave/vcd_writer.h"
#include "sim/cycle/elaboration.h"
#include "sim/waves/trace_events.h"

namespace csgsim::waves {

namespace {

/// The known run for a machine with the requested pixels only. The Program must have one segment; the pixels' places
/// are relative to its region.
systemc::EarlierRun earlier_run(const isa::Program& program, const Foreknowledge& known, const wave::Request& request) {
  systemc::EarlierRun earlier{.pixels = {},
                              .answers = known.answers,
                              .skips = known.result.skips,
                              .timeline = &known.timeline,
                              .picture = known.picture};
  const isa::Region& region = program.segments.front().region;
  for (const wave::Pixel pixel : request.pixels) earlier.pixels.push_back({pixel.x - region.x, pixel.y - region.y});
  return earlier;
}

/// A listener that ignores all events.
class NoListener final : public systemc::RunListener {};

bool can_be_probed(const isa::Program& program, const machines::Machine& machine, const wave::Request& request) {
  const isa::Region whole{0, 0, machine.array.width, machine.array.height};
  return kinds::can_be_probed(machine) && !request.pixels.empty() && program.segments.size() == 1 &&
         program.segments.front().region == whole;
}

std::unique_ptr<wave::Writer> writer_of(const Recording& recording, std::uint64_t period_ps,
                                        const wave::Request& request, Format format) {
  if (format == Format::value_changes)
    return std::make_unique<wave::VcdWriter>(recording.top, recording.taps, period_ps, request.write);
  const auto shown = format == Format::trace_events ? TraceEvents::Shown::texts : TraceEvents::Shown::all;
  return std::make_unique<TraceEvents>(recording.taps, shown, period_ps, request.write);
}

}  // namespace

systemc::EvaluatorForm evaluator_for(const machines::Machine& machine, const wave::Request& request) {
  const bool looks_into_trees = !request.tree_levels.empty() && kinds::can_be_stepped(machine);
  return looks_into_trees ? systemc::EvaluatorForm::stepped : systemc::EvaluatorForm::computed;
}

Recording record(const isa::Program& program, const machines::Machine& machine, const Foreknowledge& known,
                 const wave::Request& request, Fidelity fidelity, systemc::EvaluatorForm form, Format format) {
  cycle::claim_elaboration(machine);
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);  // suppresses the message about
                                                                                      // the stop
  const bool probes = fidelity == Fidelity::probed && can_be_probed(program, machine, request);
  const std::unique_ptr<systemc::ClockedMachine> hardware =
      probes ? kinds::make_probed_machine(machine, earlier_run(program, known, request), form)
             : kinds::make_clocked_machine(machine, form);
  const sc_core::sc_time period = systemc::period_of(machine);
  systemc::WaveRecorder recorder("wave", period);

  Recording recording{.is_window_reached = false,
                      .taps = hardware->taps(program, request),
                      .top = wave::identifier(machine.kind->name)};
  if (recording.taps.empty()) {
    throw InputError("machines of the kind " + std::string(machine.kind->name) +
                     " have no waveforms; use another --machine");
  }
  const std::uint64_t first = hardware->skip_to(program, {request.windows.front().begin, request.windows.back().end});
  const auto picoseconds = static_cast<std::uint64_t>(std::llround(period.to_seconds() * 1e12));
  recorder.arm(writer_of(recording, picoseconds, request, format), request.windows, first, true);
  NoListener no_listener;
  hardware->run(program, no_listener);
  recording.writing_seconds = recorder.writing().count();
  recording.is_window_reached = recorder.finish();
  return recording;
}

}  // namespace csgsim::waves
