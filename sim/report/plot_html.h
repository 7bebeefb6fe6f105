#pragma once

#include <string>

#include "sim/plots/plot.h"

namespace csgsim::report {

/// A plot as a figure: the picture that its file has too, in a box which scrolls where the window is too narrow, and
/// its values as tables.
std::string plot_html(const plots::Plot& plot);

}  // namespace csgsim::report
