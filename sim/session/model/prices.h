// Prices of prunings on a machine.
// Used by model_request.cpp and tests.
#pragma once

#include "host/csg/prices.h"
#include "hw/machines/machine.h"

namespace csgsim::session {

/// The times of a machine's host for the tests of prunings, and of its host and array for an instruction. They are
/// reported only: no pruning is left out because of them.
csg::Prices prices_on(const machines::Machine& machine);

/// prices_on() for `--pruning auto`: tests that take longer than they save are left out.
csg::Prices weighed_prices_on(const machines::Machine& machine);

}  // namespace csgsim::session
