#include <algorithm>
#include <string_view>
#include <utility>

#include "sim/studies/plot_names.h"
#include "sim/studies/sweep/show.h"

namespace csgsim::studies {

namespace {

/// Pseudo-axis for the machine, which is not an option of points.
constexpr Axis machine_axis{"machine", "machine", "",
                            false,     "",        nullptr,
                            nullptr,   nullptr,   [](const DesignPoint& point) { return point.machine; }};

const Axis& axis_of(std::string_view key) { return key == machine_axis.key ? machine_axis : *find_axis(key); }

/// Candidates for the x axis; the first wins among equals. The last is used if nothing else varies.
constexpr std::string_view sweep_axes[] = {"memory-bits", "z-bits",    "stack-bits", "pruning",
                                           "machine",     "colouring", "curves",     "strategy"};

/// Axes that names of points mention in addition to the strategy, in this order.
constexpr std::string_view named_axes[] = {"machine", "memory-bits", "z-bits", "pruning", "colouring", "curves"};

std::vector<std::string> values_of(std::span<const SweepRow> rows, const Axis& axis) {
  std::vector<std::string> values;
  for (const SweepRow& row : rows) {
    std::string value = axis.text(row.point);
    if (!value.empty() && std::ranges::find(values, value) == values.end()) values.push_back(std::move(value));
  }
  return values;
}

/// The axes that have several values in the rows.
std::vector<const Axis*> varied_in(std::span<const SweepRow> rows, std::span<const std::string_view> keys) {
  std::vector<const Axis*> varied;
  for (const std::string_view key : keys) {
    if (values_of(rows, axis_of(key)).size() > 1) varied.push_back(&axis_of(key));
  }
  return varied;
}

/// Appends the point's values on these axes to the text.
std::string with_values(std::string text, const DesignPoint& point, std::span<const Axis* const> axes) {
  for (const Axis* const axis : axes) {
    const std::string value = axis->text(point);
    if (axis->key == "strategy" || value.empty()) continue;
    text += (text.empty() ? "" : ", ") + std::string(axis->prefix) + value;
  }
  return text;
}

}  // namespace

PointNames::PointNames(std::span<const SweepRow> rows) : varied_(varied_in(rows, named_axes)) {}

std::string PointNames::name(const DesignPoint& point) const {
  return with_values(strategy_name(point), point, varied_);
}

std::string PointNames::conditions(const DesignPoint& point) const { return with_values("", point, varied_); }

SweepAxis::SweepAxis(std::span<const SweepRow> rows) : varied_(varied_in(rows, sweep_axes)) {
  std::size_t max_choices = 1;
  for (const Axis* const axis : varied_) {
    const std::size_t count = values_of(rows, *axis).size();
    if (count <= max_choices || axis->key == "strategy") continue;
    max_choices = count;
    shown_ = axis;
  }
  if (shown_ == nullptr) shown_ = &axis_of("strategy");
  std::erase(varied_, shown_);
  values_ = values_of(rows, *shown_);
  axis_ = {shown_->title, plots::Scale::linear, {}, !shown_->is_number};
  const std::vector<std::string> names = shown_ == &machine_axis ? machine_tick_labels(values_) : values_;
  for (std::size_t i = 0; i < values_.size(); ++i)
    axis_.ticks.push_back({shown_->is_number ? std::stod(values_[i]) : static_cast<double>(i), names[i]});
}

std::optional<double> SweepAxis::x_coordinate(const DesignPoint& point) const {
  const auto found = std::ranges::find(values_, shown_->text(point));
  if (found == values_.end()) return std::nullopt;
  return axis_.ticks[static_cast<std::size_t>(found - values_.begin())].value;
}

std::string SweepAxis::other_settings(const DesignPoint& point) const {
  return with_values(shown_->key == "strategy" ? "" : point.strategy, point, varied_);
}

}  // namespace csgsim::studies
