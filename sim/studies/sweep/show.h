// Names, checks, tables and plots of sweeps.
// Used by csgsim sweep.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/design/axes.h"

namespace csgsim::studies {

/// Names of points in a model's report, such as `list, z-bits 16`: the strategy, with stack bits if any (`bits 5`), and
/// the other options that vary.
class PointNames {
 public:
  explicit PointNames(std::span<const SweepRow> rows);

  [[nodiscard]] std::string name(const DesignPoint& point) const;

  /// The varied options other than the strategy; empty if there are none.
  [[nodiscard]] std::string conditions(const DesignPoint& point) const;

 private:
  std::vector<const Axis*> varied_;
};

/// The x axis of a sweep's plots: among memory bits, z bits, stack bits, prunings, machines, colourings and ways to
/// draw curves, the one with the most values (the first in this order among equals); the strategy if only it varies.
class SweepAxis {
 public:
  explicit SweepAxis(std::span<const SweepRow> rows);

  [[nodiscard]] const plots::Axis& axis() const { return axis_; }

  /// X coordinate of a point; empty if the point does not depend on the axis, such as a strategy without stack bits.
  [[nodiscard]] std::optional<double> x_coordinate(const DesignPoint& point) const;

  /// The point's values on the other varied axes; points with the same text form a line.
  [[nodiscard]] std::string other_settings(const DesignPoint& point) const;

 private:
  const Axis* shown_ = nullptr;
  std::vector<std::string> values_;
  std::vector<const Axis*> varied_;  ///< varied axes other than `shown_`
  plots::Axis axis_;
};

/// Groups of rows that differ only in strategy and stack bits, in the order of the rows.
std::vector<std::vector<SweepRow>> group_by_conditions(std::span<const SweepRow> rows);

/// A point whose picture is wrong.
struct WrongPicture {
  DesignPoint point;
  std::optional<DesignPoint> reference;  ///< point with the expected picture; empty if the Program overflows
};

/// Points whose picture differs from the first with the same model, size, z bits and surfaces, and points that
/// overflow.
std::vector<WrongPicture> wrong_pictures(std::span<const SweepRow> rows);

/// Prints every point, table 6.1 of the thesis, and the conclusions.
void print_sweep(std::span<const SweepRow> rows);

/// Plots of scan conversions and clocks against the varied axis (SweepAxis), of clocks against the classification bits,
/// and of the memory layout. Empty if no row was compiled.
std::vector<plots::Plot> plots_of_sweep(std::span<const SweepRow> rows, const std::string& model);

}  // namespace csgsim::studies
