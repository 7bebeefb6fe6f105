#pragma once

#include <vector>

#include "host/emit/options.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

/// Everything that must not change a picture, one change at a time.
std::vector<emit::Options> all_options();

/// The same picture in parts: lines, and squares that fit it or do not.
std::vector<Setup> in_parts(Setup how);

/// Without facets, on the machines whose expressions are of degree 2.
std::vector<Setup> on_quadratic_machines(Setup how);

}  // namespace csgsim::testing
