#include "sim/studies/sensitivity/outcome.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace csgsim::studies {

namespace {

struct Rows {
  std::span<const ExploreRow> rows;
  RowOrder order;
  std::vector<std::size_t> models;  ///< of the group
};

/// The rows of a variant of a design, one per model of the group.
std::vector<std::size_t> rows_of(const Rows& all, std::size_t design, std::size_t variant) {
  std::vector<std::size_t> rows;
  for (const std::size_t model : all.models) rows.push_back(all.order.row(model, design, variant));
  return rows;
}

bool is_drawn(const Rows& all, std::span<const std::size_t> rows) {
  return std::ranges::all_of(rows, [&](std::size_t row) { return all.rows[row].is_compiled(); });
}

VariantValues values_of(const Rows& all, std::size_t design, const ExploreAxis& axis) {
  VariantValues values;
  for (std::size_t variant = 0; variant < all.order.variants; ++variant) {
    const std::vector<std::size_t> rows = rows_of(all, design, variant);
    values.push_back(is_drawn(all, rows) ? value_of(all.rows, rows, axis) : std::nullopt);
  }
  return values;
}

MetricOutcome metric_of(const Rows& all, std::span<const std::size_t> designs, const Variants& variants,
                        const ExploreAxis& axis) {
  std::vector<VariantValues> values;
  for (const std::size_t design : designs) values.push_back(values_of(all, design, axis));
  MetricOutcome metric{axis, {}, {}, ranking_changes(variants, values)};
  for (const VariantValues& one : values) {
    metric.tornados.push_back(tornado_of(variants, one));
    metric.comparisons.push_back(&one == &values.front() ? std::nullopt : compare(variants, values.front(), one));
  }
  return metric;
}

std::vector<RefusedVariants> refused_of(const Rows& all, std::span<const std::size_t> designs) {
  std::vector<RefusedVariants> refused;
  const auto add = [&](std::size_t row) {
    const std::string& reason = all.rows[row].reason;
    if (reason.empty()) return;
    auto same = std::ranges::find(refused, reason, &RefusedVariants::reason);
    if (same == refused.end()) same = refused.insert(same, {reason, {}});
    same->rows.push_back(row);
  };
  for (const std::size_t design : designs) {
    for (std::size_t variant = 1; variant < all.order.variants; ++variant)
      std::ranges::for_each(rows_of(all, design, variant), add);
  }
  return refused;
}

SensitivityGroup group_of(const Rows& all, std::string model, const Variants& variants,
                          std::span<const ExploreAxis> axes) {
  SensitivityGroup group{std::move(model), {}, {}, {}};
  for (std::size_t design = 0; design < all.order.designs; ++design) {
    if (is_drawn(all, rows_of(all, design, 0))) group.designs.push_back(design);
  }
  if (group.designs.empty()) return group;
  for (const ExploreAxis& axis : axes) {
    MetricOutcome metric = metric_of(all, group.designs, variants, axis);
    if (std::ranges::any_of(metric.tornados, [](const auto& one) { return one.has_value(); }))
      group.metrics.push_back(std::move(metric));
  }
  group.refused = refused_of(all, group.designs);
  return group;
}

}  // namespace

std::vector<ExploreRow> stated_rows(std::span<const ExploreRow> rows, std::size_t variants) {
  std::vector<ExploreRow> stated;
  for (std::size_t i = 0; i < rows.size(); i += variants) stated.push_back(rows[i]);
  return stated;
}

SensitivityOutcome sensitivity_of(std::span<const ExploreRow> rows, std::size_t models, Variants variants,
                                  std::span<const ExploreAxis> axes) {
  SensitivityOutcome outcome{std::move(variants), {models, 0, 0}, {}};
  outcome.order.variants = outcome.variants.all.size();
  outcome.order.designs = rows.size() / (models * outcome.order.variants);
  std::vector<std::size_t> all(models);
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const std::size_t model : all) {
    const std::string& name = rows[outcome.order.row(model, 0, 0)].point.model;
    outcome.groups.push_back(group_of({rows, outcome.order, {model}}, name, outcome.variants, axes));
  }
  if (models > 1) outcome.groups.push_back(group_of({rows, outcome.order, all}, "", outcome.variants, axes));
  return outcome;
}

}  // namespace csgsim::studies
