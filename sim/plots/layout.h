#pragma once

#include <variant>

#include "sim/plots/drawing.h"
#include "sim/plots/plot.h"

namespace csgsim::plots {

/// Pixels of every plot from left to right; its height follows what is in it.
inline constexpr double plot_width = 800;

/// A place for everything that the plot shows. No two texts overlap, and none leaves the picture.
Drawing laid_out(const Chart& chart);
Drawing laid_out(const Bars& bars);
inline Drawing laid_out(const Plot& plot) {
  return std::visit([](const auto& content) { return laid_out(content); }, plot.content);
}

}  // namespace csgsim::plots
