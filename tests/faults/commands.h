#pragma once

#include <string>
#include <vector>

#include "tests/faults/bench.h"

namespace csgsim::testing::faults {

/// Every command that writes files, with all of its outputs. Studies are there from the beginning and going on with a
/// table that has all but two rows, without plots and with them.
const std::vector<Command>& commands();

/// By name.
const Command& command(const std::string& name);

}  // namespace csgsim::testing::faults
