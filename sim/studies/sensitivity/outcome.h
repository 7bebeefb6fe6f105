// Results of a sensitivity study.
// Used by sim/studies/explore and sim/studies/sensitivity.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/design/front.h"
#include "sim/studies/sensitivity/comparison.h"
#include "sim/studies/sensitivity/tornado.h"
#include "sim/studies/sensitivity/variants.h"

namespace csgsim::studies {

/// The order of the rows: all variants of a design are adjacent, and all designs of a model.
struct RowOrder {
  std::size_t models = 0;
  std::size_t designs = 0;
  std::size_t variants = 0;

  [[nodiscard]] std::size_t row(std::size_t model, std::size_t design, std::size_t variant) const {
    return (model * designs + design) * variants + variant;
  }
};

/// A metric of all designs that can be drawn with the stated figures.
struct MetricOutcome {
  ExploreAxis axis;
  std::vector<std::optional<Tornado>> tornados;        ///< one per design
  std::vector<std::optional<Comparison>> comparisons;  ///< one per design, with the first one that has a value
  Changes ranking;
};

/// Variants that cannot be drawn for the same reason.
struct RefusedVariants {
  std::string reason;
  std::vector<std::size_t> rows;
};

/// The results of one model, or of all models.
struct SensitivityGroup {
  std::string model;                 ///< empty: all models
  std::vector<std::size_t> designs;  ///< indices of the designs that can be drawn; the first is the reference
  std::vector<MetricOutcome> metrics;
  std::vector<RefusedVariants> refused;
};

struct SensitivityOutcome {
  Variants variants;
  RowOrder order;
  std::vector<SensitivityGroup> groups;  ///< one per model, and one for all models if there are several
};

/// The rows with the stated figures.
std::vector<ExploreRow> stated_rows(std::span<const ExploreRow> rows, std::size_t variants);

/// `models`: number of models.
SensitivityOutcome sensitivity_of(std::span<const ExploreRow> rows, std::size_t models, Variants variants,
                                  std::span<const ExploreAxis> axes);

}  // namespace csgsim::studies
