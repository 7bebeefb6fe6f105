#pragma once

#include "host/commands/model.h"
#include "host/read/source.h"

namespace csgsim::commands {

/// Carries out the lines of a file. Throws InputError, with the place, for what is no command.
Model interpret(read::Source& source);

}  // namespace csgsim::commands
