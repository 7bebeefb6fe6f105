// Loads Programs and matches them with machines.
// Used by sim/session, sim/app and sim/python.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"

namespace csgsim::session {

/// Reads a Program. Throws InputError, also if it does not fit into memory.
isa::Program read_program(const std::string& path);

/// The machine that runs a Program of that file, with the given parameters and the array of the Program: the machine
/// that the Program names, or `chosen_machine` if it is not empty. Prints a warning about differences between the two,
/// and about the assumption made if the Program names none. Throws InputError if the machine is of another kind or has
/// less memory than the Program needs, and as load_machine does.
machines::Machine machine_for(const isa::Program& program, const std::string& file, const std::string& chosen_machine,
                              const std::vector<std::string>& sets);

/// For a Program given to a command that also accepts models: compile options do not apply to it. Throws UsageError for
/// a given option that is not in `accepted_options` (long names without dashes); the message ends with `advice`.
void refuse_model_options(const OptionList& options, const std::set<std::string>& accepted_options,
                          const std::string& advice = "a Program has been compiled already; leave it out");

/// A Program and the machine that runs it.
struct ProgramOnMachine {
  machines::Machine machine;
  isa::Program program;
};

/// Compiles a model; anything else is read as a Program, for the machine that it names or that --machine names. Both
/// get the array of the Program. Throws InputError, or UsageError if a scene key is set for a Program.
ProgramOnMachine program_of(const ModelRequest& request, const OptionList& options);

/// As program_of() with options; `chosen_machine` is the value of --machine for a Program, empty if it was not given.
ProgramOnMachine program_of(const ModelRequest& request, const std::string& chosen_machine);

}  // namespace csgsim::session
