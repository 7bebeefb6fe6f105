// Computes positions for everything that a plot shows.
// Used by sim/report.
#pragma once

#include <variant>

#include "sim/plots/drawing.h"
#include "sim/plots/plot.h"

namespace csgsim::plots {

/// Width of every plot in pixels; the height depends on the content.
inline constexpr double plot_width = 800;

/// Places all parts of the plot. Texts neither overlap nor leave the picture.
Drawing lay_out(const Chart& chart);
Drawing lay_out(const Bars& bars);
inline Drawing lay_out(const Plot& plot) {
  return std::visit([](const auto& content) { return lay_out(content); }, plot.content);
}

}  // namespace csgsim::plots
