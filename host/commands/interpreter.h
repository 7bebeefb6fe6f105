// The interpreter of files of commands.
// Used by read.cpp.
#pragma once

#include "host/commands/model.h"
#include "host/read/source.h"

namespace csgsim::commands {

/// Executes the lines of a file. Throws InputError with the position of an invalid command.
Model interpret(read::Source& source);

}  // namespace csgsim::commands
