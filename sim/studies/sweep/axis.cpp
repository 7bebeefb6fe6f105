#include "sim/studies/sweep/axis.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "sim/studies/plot_names.h"

namespace csgsim::studies {

namespace {

/// Something that a sweep varies.
struct Dimension {
  const char* title;
  const char* before;  ///< its value, in a line's name
  bool is_number;
  std::string (*text)(const SweepPoint& point);                                      ///< empty where a point has none
  std::vector<std::string> (*ticks)(std::span<const std::string> values) = nullptr;  ///< their names on the axis
};

constexpr std::array dimensions{
    Dimension{"memory bits of a pixel", "memory ", true,
              [](const SweepPoint& p) { return std::to_string(p.memory_bits); }},
    Dimension{"bits of depth", "z ", true, [](const SweepPoint& p) { return std::to_string(p.z_bits); }},
    Dimension{"m, the bits that strategy bits is given", "m = ", true,
              [](const SweepPoint& p) { return p.stack_bits == 0 ? std::string() : std::to_string(p.stack_bits); }},
    Dimension{"prunings that are done", "pruning ", false, [](const SweepPoint& p) { return p.pruning; }},
    Dimension{"machine", "", false, [](const SweepPoint& p) { return p.machine; }, tick_names},
    Dimension{"colouring", "", false, [](const SweepPoint& p) { return p.colouring; }},
    Dimension{"curved surfaces", "curves ", false, [](const SweepPoint& p) { return p.curves; }},
    Dimension{"strategy", "", false, [](const SweepPoint& p) { return p.strategy; }},
};
constexpr std::size_t strategy_dimension = dimensions.size() - 1;

/// Those that names of points tell besides the strategy, in that order.
constexpr std::size_t told_dimensions[] = {4, 0, 1, 3, 5, 6};

std::vector<std::string> values_of(std::span<const SweepRow> rows, const Dimension& dimension) {
  std::vector<std::string> values;
  for (const SweepRow& row : rows) {
    std::string value = dimension.text(row.point);
    if (!value.empty() && std::ranges::find(values, value) == values.end()) values.push_back(std::move(value));
  }
  return values;
}

/// The point's values of these, behind the text.
std::string with_values(std::string text, const SweepPoint& point, std::span<const std::size_t> of) {
  for (const std::size_t i : of) {
    const std::string value = dimensions[i].text(point);
    if (i == strategy_dimension || value.empty()) continue;
    text += (text.empty() ? "" : ", ") + std::string(dimensions[i].before) + value;
  }
  return text;
}

}  // namespace

PointNames::PointNames(std::span<const SweepRow> rows) {
  std::ranges::copy_if(told_dimensions, std::back_inserter(varied_),
                       [&](std::size_t i) { return values_of(rows, dimensions[i]).size() > 1; });
}

std::string PointNames::name(const SweepPoint& point) const {
  return with_values(strategy_name(point), point, varied_);
}

std::string PointNames::conditions(const SweepPoint& point) const { return with_values("", point, varied_); }

SweepAxis::SweepAxis(std::span<const SweepRow> rows) : dimension_(strategy_dimension) {
  std::size_t most = 1;
  for (std::size_t i = 0; i < strategy_dimension; ++i) {
    const std::size_t count = values_of(rows, dimensions[i]).size();
    if (count <= most) continue;
    most = count;
    dimension_ = i;
  }
  values_ = values_of(rows, dimensions[dimension_]);
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    if (i != dimension_ && values_of(rows, dimensions[i]).size() > 1) varied_.push_back(i);
  }
  const bool is_number = dimensions[dimension_].is_number;
  axis_ = {dimensions[dimension_].title, plots::Scale::linear, {}, !is_number};
  const auto ticks = dimensions[dimension_].ticks;
  const std::vector<std::string> names = ticks == nullptr ? values_ : ticks(values_);
  for (std::size_t i = 0; i < values_.size(); ++i)
    axis_.ticks.push_back({is_number ? std::stod(values_[i]) : static_cast<double>(i), names[i]});
}

std::optional<double> SweepAxis::place(const SweepPoint& point) const {
  const auto found = std::ranges::find(values_, dimensions[dimension_].text(point));
  if (found == values_.end()) return std::nullopt;
  return axis_.ticks[static_cast<std::size_t>(found - values_.begin())].value;
}

std::string SweepAxis::others(const SweepPoint& point) const {
  return with_values(dimension_ == strategy_dimension ? "" : point.strategy, point, varied_);
}

}  // namespace csgsim::studies
