// The request behind csgsim run.
// Used by sim/app and sim/python.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/session/run/advice.h"
#include "sim/session/run/checkpoint_options.h"
#include "sim/session/run/finished_run.h"
#include "sim/session/run/in_place.h"
#include "sim/session/run/run_request.h"

namespace csgsim::session {

/// Options of a run of a Program.
struct ProgramRequest {
  std::string program;
  std::string machine;            ///< empty: the machine that the Program names
  std::vector<std::string> sets;  ///< KEY=VALUE of a machine parameter
  RunRequest run;
  CheckpointOptions checkpoints;

  void add_to(OptionList& options);

  /// The Program's file, and the machine's file if it has one.
  [[nodiscard]] std::vector<std::filesystem::path> inputs() const;
  /// The inputs and the resumed checkpoint.
  [[nodiscard]] std::vector<std::filesystem::path> files_read() const;
};

/// A Program and the machine that runs it.
struct LoadedProgram {
  machines::Machine machine;
  isa::Program program;
  std::vector<std::filesystem::path> inputs;
  std::string hash{};  ///< hash of a Program that replaces the file
  bool is_in_place = false;

  [[nodiscard]] RunSubject subject() const {
    return {.machine = machine, .program = program, .inputs = inputs, .hash = hash, .is_in_place = is_in_place};
  }
};

/// Throws UsageError for contradictory options, InputError for a checkpoint that cannot be written.
void refuse_misuse(const ProgramRequest& request);

/// Reads the Program, or takes its replacement. Throws InputError, UsageError.
LoadedProgram load(const ProgramRequest& request, const ContentReplacement& in_place = {});

/// Changes of machine parameters to try that may speed the run up.
Advice advice_of(const ProgramRequest& request, const machines::Machine& machine);

}  // namespace csgsim::session
