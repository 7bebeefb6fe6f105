#include <optional>
#include <string>

#include "sim/studies/sensitivity/show.h"

namespace csgsim::studies {

namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

/// The change from the base in per cent; null without a value, or if the base is 0.
Json change(const std::optional<double>& value, double base) {
  return value && base != 0 ? Json(percent_change(*value / base)) : Json(nullptr);
}

Json figure_json(const RangedFigure& figure) {
  return {{"key", figure.key},      {"of", figure.is_of_process ? "process" : "machine"},
          {"unit", figure.unit},    {"value", figure.value},
          {"low", figure.low},      {"high", figure.high},
          {"reason", figure.reason}};
}

Json samples_json(const std::optional<Percentiles>& samples) {
  if (!samples) return nullptr;
  return {{"samples", samples->samples}, {"p5", samples->p5}, {"p50", samples->p50}, {"p95", samples->p95}};
}

Json tornado_json(const Variants& variants, const Tornado& tornado) {
  Json json{{"base", tornado.base}, {"samples", samples_json(tornado.samples)}, {"figures", Json::array()}};
  for (const FigureEffect& effect : tornado.effects) {
    json["figures"].push_back({{"key", variants.figures[effect.figure].key},
                               {"low", number(effect.low)},
                               {"low_change_percent", change(effect.low, tornado.base)},
                               {"high", number(effect.high)},
                               {"high_change_percent", change(effect.high, tornado.base)},
                               {"swing", effect.swing}});
  }
  return json;
}

Json changes_json(const Variants& variants, const Changes& changes) {
  Json json{{"figures", Json::array()}, {"samples", changes.samples}};
  for (const Setting& setting : changes.figures)
    json["figures"].push_back({{"key", variants.figures[setting.figure].key}, {"value", setting.value}});
  return json;
}

Json comparison_json(const Variants& variants, const Comparison& comparison) {
  const Span span = span_of(comparison.ratio);
  return {{"ratio", tornado_json(variants, comparison.ratio)},
          {"lowest_ratio", span.low},
          {"highest_ratio", span.high},
          {"sign_changes", changes_json(variants, comparison.sign)}};
}

Json design_json(const SensitivityOutcome& outcome, const SensitivityGroup& group, std::size_t design,
                 const DesignLabels& designs) {
  Json json{{"design", designs.json[group.designs[design]]}, {"metrics", Json::array()}};
  for (const MetricOutcome& metric : group.metrics) {
    if (!metric.tornados[design]) continue;
    Json one = tornado_json(outcome.variants, *metric.tornados[design]);
    one["axis"] = metric.axis.name;
    if (metric.comparisons[design])
      one["against_first"] = comparison_json(outcome.variants, *metric.comparisons[design]);
    json["metrics"].push_back(std::move(one));
  }
  return json;
}

Json group_json(const SensitivityOutcome& outcome, const SensitivityGroup& group, const DesignLabels& designs) {
  Json json{{"model", group.model.empty() ? Json(nullptr) : Json(group.model)},
            {"designs", Json::array()},
            {"rankings", Json::array()},
            {"refused", Json::array()}};
  for (std::size_t i = 0; i < group.designs.size(); ++i)
    json["designs"].push_back(design_json(outcome, group, i, designs));
  for (const MetricOutcome& metric : group.metrics)
    json["rankings"].push_back(
        {{"axis", metric.axis.name}, {"changes", changes_json(outcome.variants, metric.ranking)}});
  for (const RefusedVariants& refused : group.refused)
    json["refused"].push_back({{"reason", refused.reason}, {"points", refused.rows}});
  return json;
}

}  // namespace

Json variant_json(const Variants& variants, std::size_t variant) {
  Json json = Json::object();
  for (const Setting& setting : variants.all[variant]) json[variants.figures[setting.figure].key] = setting.value;
  return json;
}

Json sensitivity_json(const SensitivityOutcome& outcome, const DesignLabels& designs) {
  Json json{{"figures", Json::array()},
            {"variants", outcome.order.variants},
            {"samples", outcome.variants.samples.size()},
            {"groups", Json::array()}};
  for (const RangedFigure& figure : outcome.variants.figures) json["figures"].push_back(figure_json(figure));
  for (const SensitivityGroup& group : outcome.groups) json["groups"].push_back(group_json(outcome, group, designs));
  return json;
}

}  // namespace csgsim::studies
