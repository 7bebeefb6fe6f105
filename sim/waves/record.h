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

/// What of the machine is stepped.
enum class Fidelity : std::uint8_t {
  probed,  ///< where the kind can: the probed pixels alone, from shortly before the first window on
  whole,   ///< all of it, from the frame's first clock on
};

/// Of the trees: stepped where the request looks into them and they can be, else worked out.
systemc::EvaluatorForm evaluator_for(const machines::Machine& machine, const wave::Request& request);

/// What a file is.
enum class Format : std::uint8_t {
  value_changes,     ///< a value change dump
  trace_events,      ///< what parts are at: TraceEvents of the texts
  all_trace_events,  ///< TraceEvents of texts and numbers
};

/// What a file has been written of.
struct Recording {
  double writing_seconds = 0;   ///< wall time to sample the taps and to write what they show
  bool reached = false;         ///< a window: else the frame is over before the first
  std::vector<wave::Tap> taps;  ///< as they are in the file, within `top`; not to be sampled
  std::string top;
};

/// Runs the Program on the clocked machine until the last window is over, and writes the windows to request.write. One
/// run a process: SystemC elaborates once. Throws InputError for a machine without waves, and for a pixel or tree level
/// that the machine has not, or for trees that it cannot have in that form.
Recording record(const isa::Program& program, const machines::Machine& machine, const Foreknowledge& known,
                 const wave::Request& request, Fidelity fidelity, systemc::EvaluatorForm form, Format format);

}  // namespace csgsim::waves
