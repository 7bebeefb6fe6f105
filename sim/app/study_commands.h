#pragma once

#include <span>

#include "sim/shell/command_line.h"
#include "sim/studies/study.h"

namespace csgsim::app {

/// Adds the study to the line: its command measures what its table has not yet, and shows all.
void add_study(shell::CommandLine& line, const studies::StudyRow& row);

/// Adds the command that joins shards of these studies. The rows live as long as the line.
void add_gather(shell::CommandLine& line, std::span<const studies::StudyRow* const> studies);

}  // namespace csgsim::app
