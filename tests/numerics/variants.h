#pragma once

#include <vector>

#include "host/emit/options.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

/// All options that must not change a picture, one change at a time.
std::vector<emit::Options> all_options();

/// The same picture divided into lines and into squares, including squares that do not fit it.
std::vector<Setup> setups_in_parts(Setup setup);

/// The same picture without facets, on the machines whose expressions are of degree 2.
std::vector<Setup> setups_on_quadratic_machines(Setup setup);

}  // namespace csgsim::testing
