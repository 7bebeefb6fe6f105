#include "sim/studies/sensitivity/variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/studies/sensitivity/samples.h"

namespace csgsim::studies {

namespace {

/// The index of the variant, which is added if it is new.
std::size_t place_of(Variant variant, std::vector<Variant>& all) {
  const auto found = std::ranges::find(all, variant);
  if (found != all.end()) return static_cast<std::size_t>(found - all.begin());
  all.push_back(std::move(variant));
  return all.size() - 1;
}

Variant with_value(const Variants& variants, std::size_t figure, std::int64_t value, Variant variant = {}) {
  if (value != variants.figures[figure].value) variant.push_back({figure, value});
  return variant;
}

void add_samples(const SampleChoice& choice, Variants& variants) {
  std::vector<Variant> samples(choice.samples);
  for (std::size_t figure = 0; figure < variants.figures.size(); ++figure) {
    const RangedFigure& ranged = variants.figures[figure];
    const std::vector<double> positions = strata(ranged.key, choice.samples, choice.seed);
    for (std::size_t i = 0; i < samples.size(); ++i)
      samples[i] = with_value(variants, figure, value_at(ranged, positions[i]), std::move(samples[i]));
  }
  for (Variant& sample : samples) variants.samples.push_back(place_of(std::move(sample), variants.all));
}

}  // namespace

Variants make_variants(std::vector<RangedFigure> figures, const SampleChoice& choice) {
  Variants variants{std::move(figures), {{}}};
  for (std::size_t i = 0; i < variants.figures.size(); ++i) {
    variants.low.push_back(place_of(with_value(variants, i, variants.figures[i].low), variants.all));
    variants.high.push_back(place_of(with_value(variants, i, variants.figures[i].high), variants.all));
  }
  add_samples(choice, variants);
  return variants;
}

std::string name_suffix(const Variants& variants, const Variant& variant, bool is_of_process) {
  std::string suffix;
  for (const Setting& setting : variant) {
    const RangedFigure& figure = variants.figures[setting.figure];
    if (figure.is_of_process == is_of_process) suffix += fmt::format("+{}={}", figure.key, setting.value);
  }
  return suffix;
}

std::string variant_text(const Variants& variants, const Variant& variant) {
  std::string text;
  for (const Setting& setting : variant)
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", variants.figures[setting.figure].key, setting.value);
  return text;
}

}  // namespace csgsim::studies
