#pragma once

#include <string>

#include "sim/plots/plot.h"

namespace csgsim::plots {

/// What is told of a point where somebody points at it.
std::string tip_of(const Chart& chart, const Series& series, const Point& point);

/// The same of a part of a bar.
std::string tip_of(const Bars& plot, const Bar& bar, const Part& part);

}  // namespace csgsim::plots
