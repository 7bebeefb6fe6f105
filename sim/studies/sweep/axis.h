#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/sweep/points.h"

namespace csgsim::studies {

/// What a point is called within its model's report: those dimensions that vary there, as `list, z-bits 16`.
/// The strategy is always said, with its stack bits as `bits 5`.
class PointNames {
 public:
  explicit PointNames(std::span<const SweepRow> rows);

  [[nodiscard]] std::string name(const SweepPoint& point) const;

  /// Without the strategy; empty where nothing else varies.
  [[nodiscard]] std::string conditions(const SweepPoint& point) const;

 private:
  std::vector<std::size_t> varied_;
};

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
