#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/design/axes.h"

namespace csgsim::studies {

/// What a point is called within its model's report: those dimensions that vary there, as `list, z-bits 16`.
/// The strategy is always said, with its stack bits as `bits 5`.
class PointNames {
 public:
  explicit PointNames(std::span<const SweepRow> rows);

  [[nodiscard]] std::string name(const DesignPoint& point) const;

  /// The varied options other than the strategy; empty if there are none.
  [[nodiscard]] std::string conditions(const DesignPoint& point) const;

 private:
  std::vector<const Axis*> varied_;
};

/// What a sweep of one model varies, as the x axis of its plots: of memory bits, z bits, stack bits, prunings, machines
/// and colourings that with the most values, of equals the first in this order; the strategy where only it varies.
class SweepAxis {
 public:
  explicit SweepAxis(std::span<const SweepRow> rows);

  [[nodiscard]] const plots::Axis& axis() const { return axis_; }

  /// The abscissa of a point; none if it does not depend on the axis, as a strategy without stack bits.
  [[nodiscard]] std::optional<double> place(const DesignPoint& point) const;

  /// What else varies, of a point: points of the same text are a line.
  [[nodiscard]] std::string others(const DesignPoint& point) const;

 private:
  const Axis* shown_ = nullptr;
  std::vector<std::string> values_;
  std::vector<const Axis*> varied_;  ///< beside the one shown
  plots::Axis axis_;
};

/// Rows that differ in strategy and stack bits only, in the order of the rows.
std::vector<std::vector<SweepRow>> by_conditions(std::span<const SweepRow> rows);

/// A point whose picture is not what it has to be.
struct WrongPicture {
  DesignPoint point;
  std::optional<DesignPoint> reference;  ///< the point whose picture it should have; none where the Program overflows
};

/// Points whose picture differs from the first of the same model, size, z bits and surfaces, and those that overflow.
std::vector<WrongPicture> wrong_pictures(std::span<const SweepRow> rows);

/// On standard output: every point, table 6.1 of the thesis, and what follows from them.
void print_sweep(std::span<const SweepRow> rows);

/// Scan-conversions and clocks against what is varied (SweepAxis), clocks against the memory bits that the
/// classification uses, and what each memory bit holds. None where no row has been compiled.
std::vector<plots::Plot> plots_of_sweep(std::span<const SweepRow> rows, const std::string& model);

}  // namespace csgsim::studies
