// Output of a sensitivity study: texts, JSON, plots and tables of a page.
// Used by sim/studies/explore and sim/studies/sensitivity.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/report/page.h"
#include "sim/studies/sensitivity/outcome.h"

namespace csgsim::studies {

/// Names of the designs, in their order.
struct DesignLabels {
  std::vector<std::string> texts;
  std::vector<nlohmann::ordered_json> json;  ///< the values that vary
};

/// The change of a value in per cent, given its ratio to the reference.
inline double percent_change(double ratio) { return 100 * (ratio - 1); }

/// A change such as `+34 %` or `-3.2 %`, given the ratio of a value to its reference.
std::string change_text(double ratio);

/// Prints the comparisons of every group, and the effect of each figure on the last group: that of all models if there
/// are several.
void print_sensitivity(std::span<const ExploreRow> rows, const SensitivityOutcome& outcome,
                       const DesignLabels& designs);

/// The values of the figures that a variant sets.
nlohmann::ordered_json variant_json(const Variants& variants, std::size_t variant);

nlohmann::ordered_json sensitivity_json(const SensitivityOutcome& outcome, const DesignLabels& designs);

/// Bars of the effects of figures on each metric of each design of the last group, and on the ratio to the reference;
/// at most `max_tornados` plots.
std::vector<plots::Plot> plots_of_sensitivity(const SensitivityOutcome& outcome, const DesignLabels& designs);
inline constexpr std::size_t max_tornados = 24;

/// The tables of a page, given its data with a `sensitivity`.
report::Section sensitivity_section(const report::Json& data);

}  // namespace csgsim::studies
