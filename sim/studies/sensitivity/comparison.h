// Comparisons of designs over the ranges of figures.
// Used by sim/studies/sensitivity.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sim/studies/sensitivity/tornado.h"

namespace csgsim::studies {

/// The variants in which a comparison differs from that with the stated figures. Variants without the values that it
/// needs are not counted.
struct Changes {
  std::vector<Setting> figures;  ///< the single figures
  std::size_t samples = 0;       ///< number of samples

  bool operator==(const Changes&) const = default;
};

/// A metric of a design divided by that of the reference.
struct Comparison {
  Tornado ratio;
  Changes sign;  ///< where the other of the two is lower, or neither
};

/// Empty if the ratio has no value with the stated figures.
std::optional<Comparison> compare(const Variants& variants, const VariantValues& reference,
                                  const VariantValues& design);

/// The variants in which the order of any two designs differs.
Changes ranking_changes(const Variants& variants, std::span<const VariantValues> designs);

}  // namespace csgsim::studies
