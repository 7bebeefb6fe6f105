#pragma once

#include <span>

#include "sim/shell/command_line.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

/// Adds the command that joins shards of these studies. The rows live as long as the line.
void add_gather(shell::CommandLine& line, std::span<const StudyRow* const> studies);

}  // namespace csgsim::studies
