// The effect of each figure on one metric of a design.
// Used by sim/studies/sensitivity.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/studies/sensitivity/variants.h"

namespace csgsim::studies {

/// A metric of a design in each of the Variants; empty where the design cannot be drawn or has no price.
using VariantValues = std::vector<std::optional<double>>;

/// Percentiles over the samples that have a value, by quantile().
struct Percentiles {
  std::size_t samples = 0;  ///< number of samples that have a value
  double p5 = 0;
  double p50 = 0;
  double p95 = 0;

  bool operator==(const Percentiles&) const = default;
};

/// Empty if there are no values.
std::optional<Percentiles> percentiles_of(std::vector<double> values);

/// The metric with one figure at the ends of its range.
struct FigureEffect {
  std::size_t figure = 0;  ///< index
  std::optional<double> low{};
  std::optional<double> high{};
  double swing = 0;  ///< difference between the largest and the smallest of the stated, the low and the high case

  bool operator==(const FigureEffect&) const = default;
};

struct Tornado {
  double base = 0;                    ///< with all figures as stated
  std::vector<FigureEffect> effects;  ///< of all figures, the largest swing first, then in the order of the figures
  std::optional<Percentiles> samples{};
};

/// Empty if the metric has no value with the stated figures.
std::optional<Tornado> tornado_of(const Variants& variants, const VariantValues& values);

/// The smallest and the largest value with at most one figure changed.
struct Span {
  double low = 0;
  double high = 0;
};
Span span_of(const Tornado& tornado);

/// Number of figures whose low and high values both equal the stated case.
std::size_t without_effect(const Tornado& tornado);

}  // namespace csgsim::studies
