// Row-command traces of a run.
// Used by sim/app.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/run_outcome.h"
#include "hw/machines/timing.h"
#include "sim/rows/forms.h"

namespace csgsim::rows {

/// Something that the form of a trace cannot express, and its replacement.
struct Replacement {
  std::string what;         ///< a command or another feature, as in `masks of writes`
  std::string instead;      ///< what the trace contains instead, as in `nothing`
  std::uint64_t count = 0;  ///< number of replacements
};

struct TraceSummary {
  std::uint64_t commands = 0;  ///< row commands, counted once for all slots
  std::uint64_t lines = 0;
  machines::FrameTiming timing;
  std::vector<Replacement> replacements;
};

/// Writes the row commands of a frame, with their clocks, by calls of `write`. `outcomes` are those of the run.
/// `command_set`, if not null, replaces the gates. Throws InputError if the machine is of another kind or, with a set,
/// without latches; if its geometry does not fit the form; and if the set lacks a gate.
TraceSummary write_trace(const isa::Program& program, const machines::Machine& machine,
                         const machines::RunOutcome& outcomes, const FormRow& form_row,
                         const std::function<void(std::string_view)>& write,
                         const bit_serial_memory::CommandSet* command_set = nullptr);

}  // namespace csgsim::rows
