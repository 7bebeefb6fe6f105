#pragma once

#include <set>
#include <string>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/app/command_line.h"
#include "sim/app/model_options.h"

namespace csgsim::app {

/// For commands that take a model or a Program. A Program has been compiled: what says how to compile has no meaning
/// for it. Throws UsageError where an option was given that is none of the command's `own`, by their long names
/// without dashes.
void refuse_model_options(const Command& command, const std::set<std::string>& own);

/// A model is compiled; anything else is a Program, and the machine gets the array it is made for. Throws InputError,
/// or UsageError where a key of the scene is set for a Program.
isa::Program program_of(const ModelOptions& options, machines::Machine& machine);

}  // namespace csgsim::app
