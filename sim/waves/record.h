// Records waveforms of a clocked machine.
// Used by sim/waves and sim/app.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/systemc/evaluator_form.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"
#include "sim/waves/foreknowledge.h"

namespace csgsim::waves {

/// The simulated part of the machine.
enum class Fidelity : std::uint8_t {
  probed,  ///< only the probed pixels, from shortly before the first window, if the kind supports it
  whole,   ///< everything, from the first clock of the frame
};

/// Form of the multiplier trees: stepped adder by adder if the request probes them and the kind supports it, otherwise
/// computed from the coefficients.
systemc::EvaluatorForm evaluator_for(const machines::Machine& machine, const wave::Request& request);

/// Format of the output.
enum class Format : std::uint8_t {
  value_changes,     ///< a value change dump
  trace_events,      ///< activities of units: trace events (trace_events.h) of taps with texts
  all_trace_events,  ///< trace events of all taps: texts and numbers
};

/// The result of a recording.
struct Recording {
  double writing_seconds = 0;      ///< wall time for sampling and writing
  bool is_window_reached = false;  ///< a window was reached; otherwise the frame ended before the first window
  std::vector<wave::Tap> taps;     ///< taps of the file, within `top`, for names and formats; must not be sampled
  std::string top;
};

/// Runs the Program on the clocked machine until the end of the last window, and writes the windows to request.write.
/// Only one run per process is possible, since SystemC elaborates once. Throws InputError for a machine without
/// waveforms, for a nonexistent pixel or tree level, and if the machine does not support that form of trees.
Recording record(const isa::Program& program, const machines::Machine& machine, const Foreknowledge& known,
                 const wave::Request& request, Fidelity fidelity, systemc::EvaluatorForm form, Format format);

}  // namespace csgsim::waves
