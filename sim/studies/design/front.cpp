#include "sim/studies/design/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "sim/session/options/lists.h"

namespace csgsim::studies {

namespace {

constexpr ExploreAxis front_axes[] = {
    {"time", "time between frames, ms",
     [](const ExploreRow& row) { return std::optional(1e3 / row.frames_per_second); }, true, false},
    {"area", "transistors in total",
     [](const ExploreRow& row) {
       return row.machine_transistors ? std::optional(static_cast<double>(*row.machine_transistors)) : std::nullopt;
     },
     false, false},
    {"silicon", "area, mm²", [](const ExploreRow& row) { return row.machine_mm2; }, false, false},
    {"energy", "energy per frame, J", [](const ExploreRow& row) { return row.frame_joules; }, true, false},
    {"memory", "memory bits in total",
     [](const ExploreRow& row) { return std::optional(static_cast<double>(row.machine_memory_bits)); }, false, false},
    {"wrong", "wrong pixels", [](const ExploreRow& row) { return std::optional(static_cast<double>(row.wrong)); }, true,
     true},
};

bool is_at_most(const Values& a, const Values& b) {
  for (std::size_t axis = 0; axis < a.size(); ++axis)
    if (a[axis] > b[axis]) return false;
  return true;
}

double stretched(double value, const ExploreAxis& axis) { return std::log(axis.may_be_zero ? 1 + value : value); }

/// Row indices of a design, one per model.
using Design = std::vector<std::size_t>;

ExploreGroup group_of(std::span<const ExploreRow> rows, std::string model, std::vector<Design> designs,
                      std::span<const ExploreAxis> axes) {
  ExploreGroup group{std::move(model), {}, {}, {}, {}, {}};
  group.refused = std::erase_if(designs, [&](const Design& design) {
    return !std::ranges::all_of(design, [&](std::size_t row) { return rows[row].is_compiled(); });
  });
  for (const ExploreAxis& axis : axes) {
    const auto has_price = [&](const Design& design) { return value_of(rows, design, axis).has_value(); };
    if (std::ranges::any_of(designs, has_price)) group.axes.push_back(axis);
  }
  for (const Design& design : designs) {
    Values values;
    for (const ExploreAxis& axis : group.axes) {
      if (const std::optional<double> value = value_of(rows, design, axis)) values.push_back(*value);
    }
    if (values.size() < group.axes.size()) {
      ++group.unpriced;
      continue;
    }
    group.rows.push_back(design.front());
    group.values.push_back(std::move(values));
  }
  group.front = pareto_flags(group.values);
  group.knee = find_knee(group.values, group.front, group.axes);
  return group;
}

}  // namespace

std::optional<double> value_of(std::span<const ExploreRow> rows, std::span<const std::size_t> design,
                               const ExploreAxis& axis) {
  double all = 0;
  for (const std::size_t row : design) {
    const std::optional<double> one = axis.value(rows[row]);
    if (!one) return std::nullopt;
    all = axis.is_of_picture ? all + *one : std::max(all, *one);
  }
  return all;
}

std::span<const ExploreAxis> explore_axes() { return front_axes; }

std::vector<std::string> explore_axis_names() {
  std::vector<std::string> names;
  for (const ExploreAxis& axis : front_axes) names.emplace_back(axis.name);
  return names;
}

std::vector<ExploreAxis> parse_axes(const std::string& text) {
  std::vector<ExploreAxis> axes;
  for (const std::string& name : session::parse_names(text, "axis", explore_axis_names()))
    axes.push_back(*std::ranges::find(front_axes, name, &ExploreAxis::name));
  return axes;
}

std::vector<bool> pareto_flags(std::span<const Values> candidates) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // This order puts every candidate after those that dominate it, so it needs to be compared with the current front
  // only.
  std::ranges::stable_sort(order, {}, [&](std::size_t one) -> const Values& { return candidates[one]; });
  std::vector<bool> is_best(candidates.size());
  std::vector<std::size_t> front;
  for (const std::size_t one : order) {
    const Values& values = candidates[one];
    const bool is_dominated = std::ranges::any_of(
        front, [&](std::size_t other) { return candidates[other] != values && is_at_most(candidates[other], values); });
    if (is_dominated) continue;
    is_best[one] = true;
    front.push_back(one);
  }
  return is_best;
}

std::vector<std::size_t> front_indices(std::span<const Values> candidates) {
  const std::vector<bool> is_best = pareto_flags(candidates);
  std::set<Values> known;
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (is_best[i] && known.insert(candidates[i]).second) front.push_back(i);
  }
  std::ranges::sort(front, {}, [&](std::size_t one) -> const Values& { return candidates[one]; });
  return front;
}

std::optional<std::size_t> find_knee(std::span<const Values> candidates, const std::vector<bool>& front,
                                     std::span<const ExploreAxis> axes) {
  std::vector<std::pair<double, double>> ranges(
      axes.size(), {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!front[i]) continue;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const double value = stretched(candidates[i][axis], axes[axis]);
      ranges[axis] = {std::min(ranges[axis].first, value), std::max(ranges[axis].second, value)};
    }
  }
  std::optional<std::size_t> knee;
  double min_distance = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!front[i]) continue;
    double distance = 0;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const auto& [low, high] = ranges[axis];
      const double part = high > low ? (stretched(candidates[i][axis], axes[axis]) - low) / (high - low) : 0;
      distance += part * part;
    }
    if (knee && distance >= min_distance) continue;
    knee = i;
    min_distance = distance;
  }
  return knee;
}

std::vector<ExploreGroup> groups_of(std::span<const ExploreRow> rows, std::span<const ExploreAxis> axes) {
  std::vector<std::string> models;
  std::map<std::string, std::vector<Design>> group_by_model;
  std::map<DesignPoint, std::size_t> numbers;  // index of each design, independent of the model
  std::vector<Design> of_all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    DesignPoint design = rows[i].point;
    std::vector<Design>& of_model = group_by_model[design.model];
    if (of_model.empty()) models.push_back(design.model);
    of_model.push_back({i});
    design.model.clear();
    const auto [number, is_new] = numbers.emplace(std::move(design), of_all.size());
    if (is_new) of_all.emplace_back();
    of_all[number->second].push_back(i);
  }
  std::vector<ExploreGroup> groups;
  groups.reserve(models.size() + 1);
  for (const std::string& model : models) groups.push_back(group_of(rows, model, group_by_model[model], axes));
  if (models.size() > 1) groups.push_back(group_of(rows, "", of_all, axes));
  return groups;
}

}  // namespace csgsim::studies
