// Commands of the studies and of `csgsim gather`.
// Used by main() and the tests of studies.
#pragma once

#include <span>

#include "sim/shell/command_line.h"
#include "sim/studies/study.h"

namespace csgsim::app {

/// Adds the study's command, which measures the points missing from its table and prints the results.
void add_study_command(shell::CommandLine& line, const studies::StudyRow& row);

/// Adds the command that joins the shards of these studies. The rows must outlive the line.
void add_gather_command(shell::CommandLine& line, std::span<const studies::StudyRow* const> studies);

}  // namespace csgsim::app
