// Prices of prunings on a machine.
// Used by model_request.cpp and tests.
#pragma once

#include "host/csg/prices.h"
#include "hw/machines/machine.h"

namespace csgsim::session {

/// The prices of a machine's host and of its array, which are reported but decide nothing.
csg::Prices prices_on(const machines::Machine& machine);

/// prices_on() for `--pruning auto`: tests that are not worth their time are left out.
csg::Prices weighed_prices_on(const machines::Machine& machine);

}  // namespace csgsim::session
