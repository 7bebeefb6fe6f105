#pragma once

#include <set>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"

namespace csgsim::session {

/// Reads a Program. Throws InputError, also where memory does not hold it.
isa::Program read_program(const std::string& path);

/// The machine that runs a Program of that file, with the figures that are set and the array that the Program is for:
/// the one that the Program names, or `asked`, if that is not empty. Says on standard error in what the machine that is
/// asked for differs, and what is assumed of a Program that names none. Throws InputError where the machine is of
/// another kind than the Program's or has less memory, and as load_machine does.
machines::Machine machine_for(const isa::Program& program, const std::string& file, const std::string& asked,
                              const std::vector<std::string>& sets);

/// For commands that take a model or a Program. A Program has been compiled: what says how to compile has no meaning
/// for it. Throws UsageError where an option was given that is none of the command's `own`, by their long names
/// without dashes; `why` ends the message.
void refuse_model_options(const OptionList& options, const std::set<std::string>& own,
                          const std::string& why = "a Program has been compiled already");

/// What is run, and what runs it.
struct ProgramOnMachine {
  machines::Machine machine;
  isa::Program program;
};

/// A model is compiled; anything else is a Program, and its machine the one that it names, or that --machine names.
/// Both get the array that the Program is for. Throws InputError, or UsageError where a key of the scene is set for a
/// Program.
ProgramOnMachine program_of(const ModelRequest& request, const OptionList& options);

/// The same, where `asked` is what --machine of a Program says; empty if it was not given.
ProgramOnMachine program_of(const ModelRequest& request, const std::string& asked);

}  // namespace csgsim::session
