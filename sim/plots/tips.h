// Tooltips of plots.
// Used by the layouts.
#pragma once

#include <string>

#include "sim/plots/plot.h"

namespace csgsim::plots {

/// Tooltip of a point.
std::string tip_text(const Chart& chart, const Series& series, const Point& point);

/// Tooltip of a part of a bar.
std::string tip_text(const Bars& plot, const Bar& bar, const Part& part);

}  // namespace csgsim::plots
