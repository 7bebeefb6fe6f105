#include "sim/studies/sensitivity/tornado.h"

#include <algorithm>

#include "sim/studies/quantile.h"

namespace csgsim::studies {

namespace {

FigureEffect effect_of(std::size_t figure, double base, const Variants& variants, const VariantValues& values) {
  FigureEffect effect{figure, values[variants.low[figure]], values[variants.high[figure]]};
  const double low = effect.low.value_or(base);
  const double high = effect.high.value_or(base);
  effect.swing = std::max({base, low, high}) - std::min({base, low, high});
  return effect;
}

}  // namespace

std::optional<Percentiles> percentiles_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  return Percentiles{values.size(), quantile(values, 0.05), quantile(values, 0.5), quantile(values, 0.95)};
}

std::optional<Tornado> tornado_of(const Variants& variants, const VariantValues& values) {
  if (!values.front()) return std::nullopt;
  Tornado tornado{*values.front(), {}};
  for (std::size_t figure = 0; figure < variants.figures.size(); ++figure)
    tornado.effects.push_back(effect_of(figure, tornado.base, variants, values));
  std::ranges::stable_sort(tornado.effects, std::ranges::greater{}, &FigureEffect::swing);
  std::vector<double> samples;
  for (const std::size_t sample : variants.samples) {
    if (values[sample]) samples.push_back(*values[sample]);
  }
  tornado.samples = percentiles_of(std::move(samples));
  return tornado;
}

Span span_of(const Tornado& tornado) {
  Span span{tornado.base, tornado.base};
  for (const FigureEffect& effect : tornado.effects) {
    for (const std::optional<double>& value : {effect.low, effect.high}) {
      span.low = std::min(span.low, value.value_or(span.low));
      span.high = std::max(span.high, value.value_or(span.high));
    }
  }
  return span;
}

std::size_t without_effect(const Tornado& tornado) {
  return static_cast<std::size_t>(std::ranges::count_if(
      tornado.effects, [](const FigureEffect& effect) { return effect.swing == 0 && effect.low && effect.high; }));
}

}  // namespace csgsim::studies
