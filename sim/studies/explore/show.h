// Output of csgsim explore: texts, JSON and plots.
// Used by csgsim explore.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/design/front.h"
#include "sim/studies/sensitivity/outcome.h"
#include "sim/studies/sensitivity/show.h"

namespace csgsim::studies {

/// Names of designs by the parameters and options that vary among some rows.
class DesignNames {
 public:
  explicit DesignNames(std::span<const ExploreRow> rows);

  /// Keys as in --vary, without `machine` and `model`.
  [[nodiscard]] const std::vector<std::string>& keys() const { return keys_; }
  /// Value of each key; empty if the design has none.
  [[nodiscard]] std::vector<std::string> values(const DesignPoint& point) const;
  /// Text such as `alu.bits=4, strategy=list`.
  [[nodiscard]] std::string text(const DesignPoint& point) const;

 private:
  std::vector<std::string> keys_;
};

/// A group and the commands that draw its knee, one per model.
struct ShownGroup {
  ExploreGroup group;
  std::vector<std::string> commands;
};

/// Prints, for each group, the number of designs, the front and the knee.
void print_explored(std::span<const ExploreRow> rows, std::span<const ShownGroup> groups);

/// The names of the designs by what varies among those that can be drawn, given the rows with the stated figures.
DesignLabels designs_of(std::span<const ExploreRow> stated, const SensitivityOutcome& sensitivity);

/// explore.json: all points, with whether each is on its model's front and whether it is the knee; the groups; and the
/// sensitivity, if it was measured.
std::string explore_json(const std::string& title, std::span<const ExploreRow> rows, std::span<const ShownGroup> groups,
                         const SensitivityOutcome* sensitivity = nullptr);

/// One chart per group with at least two axes, of the first axis against each of the others: all designs, those on
/// the front, the front of these two axes alone, and the knee.
std::vector<plots::Plot> plots_of_explore(std::span<const ShownGroup> groups);

}  // namespace csgsim::studies
