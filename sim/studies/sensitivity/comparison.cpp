#include "sim/studies/sensitivity/comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace csgsim::studies {

namespace {

/// Values whose relative difference is at most this are equal.
constexpr double tolerance = 1e-9;

/// -1 if the design's value is lower than the reference's, 1 if it is higher.
int sign_of(double reference, double design) {
  if (std::abs(design - reference) <= tolerance * std::max(std::abs(design), std::abs(reference))) return 0;
  return design < reference ? -1 : 1;
}

std::optional<int> sign_in(std::size_t variant, const VariantValues& reference, const VariantValues& design) {
  if (!reference[variant] || !design[variant]) return std::nullopt;
  return sign_of(*reference[variant], *design[variant]);
}

bool has_other_sign(std::size_t variant, const VariantValues& reference, const VariantValues& design) {
  const std::optional<int> stated = sign_in(0, reference, design);
  const std::optional<int> sign = sign_in(variant, reference, design);
  return stated && sign && *stated != *sign;
}

/// The variants for which `is_other(index)` holds.
template <class IsOther>
Changes changes_where(const Variants& variants, const IsOther& is_other) {
  Changes changes;
  for (std::size_t i = 0; i < variants.figures.size(); ++i) {
    if (is_other(variants.low[i])) changes.figures.push_back({i, variants.figures[i].low});
    if (is_other(variants.high[i])) changes.figures.push_back({i, variants.figures[i].high});
  }
  changes.samples = static_cast<std::size_t>(std::ranges::count_if(variants.samples, is_other));
  return changes;
}

std::optional<double> ratio_of(const std::optional<double>& reference, const std::optional<double>& design) {
  if (!reference || !design || *reference == 0) return std::nullopt;
  return *design / *reference;
}

}  // namespace

std::optional<Comparison> compare(const Variants& variants, const VariantValues& reference,
                                  const VariantValues& design) {
  VariantValues ratios;
  for (std::size_t i = 0; i < reference.size(); ++i) ratios.push_back(ratio_of(reference[i], design[i]));
  std::optional<Tornado> ratio = tornado_of(variants, ratios);
  if (!ratio) return std::nullopt;
  const auto is_other = [&](std::size_t variant) { return has_other_sign(variant, reference, design); };
  return Comparison{std::move(*ratio), changes_where(variants, is_other)};
}

Changes ranking_changes(const Variants& variants, std::span<const VariantValues> designs) {
  return changes_where(variants, [&](std::size_t variant) {
    for (std::size_t i = 0; i < designs.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        if (has_other_sign(variant, designs[j], designs[i])) return true;
    }
    return false;
  });
}

}  // namespace csgsim::studies
