#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/sweep/points.h"

namespace csgsim::studies {

/// What a sweep of one model varies, as the x axis of its plots: of memory bits, z bits, stack bits, prunings, machines
/// and colourings that with the most values, of equals the first in this order; the strategy where only it varies.
class SweepAxis {
 public:
  explicit SweepAxis(std::span<const SweepRow> rows);

  [[nodiscard]] const plots::Axis& axis() const { return axis_; }

  /// Where a point stands; none where it is the same for all of the axis: a strategy without stack bits.
  [[nodiscard]] std::optional<double> place(const SweepPoint& point) const;

  /// What else varies, of a point: points of the same text are a line.
  [[nodiscard]] std::string others(const SweepPoint& point) const;

 private:
  std::size_t dimension_;
  std::vector<std::string> values_;
  std::vector<std::size_t> varied_;
  plots::Axis axis_;
};

}  // namespace csgsim::studies
