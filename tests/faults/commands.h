#pragma once

#include <string>
#include <vector>

#include "tests/faults/bench.h"

namespace csgsim::testing::faults {

/// Every command that writes files, with all of its outputs. Each study occurs in a first run and as a continuation of
/// a table without its last two rows, with and without plots.
const std::vector<Command>& commands();

/// The command of that name.
const Command& command(const std::string& name);

}  // namespace csgsim::testing::faults
