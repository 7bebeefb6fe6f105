#pragma once

#include <span>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/report/page.h"

namespace csgsim::report {

/// What a study draws as files, as plots of a page: one for each panel that has points.
std::vector<Plot> page_plots(const plots::Chart& chart);

/// A section of the charts among these.
Section plots_section(std::span<const plots::Plot> plots);

}  // namespace csgsim::report
