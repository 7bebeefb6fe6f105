#include "sim/plots/extent.h"

#include <algorithm>
#include <cmath>

#include "sim/plots/ticks.h"

namespace csgsim::plots {

namespace {

constexpr double margin = 0.06;          ///< fraction of the axis, at both ends
constexpr double room_for_zero = 0.2;    ///< fraction of the axis below the smallest positive value
constexpr double place_of_zero = 0.05;   ///< position along the axis
constexpr double logarithmic_from = 20;  ///< ratio of maximum to smallest positive value
constexpr double near_greatest = 0.4;    ///< fraction of the maximum
constexpr double min_shown = 1e-250;     ///< lower limit of a logarithmic axis, so that the margin below it is not 0
constexpr double max_shown = 1e250;      ///< larger values are clamped to the edge, so that differences stay finite

bool is_logarithmic(std::span<const double> values, double min_positive, Scale scale) {
  if (scale == Scale::linear || min_positive == 0 || *std::ranges::min_element(values) < 0) return false;
  return scale == Scale::logarithmic || *std::ranges::max_element(values) / min_positive >= logarithmic_from;
}

bool begins_at_zero(double minimum, double maximum, Begin begin) {
  if (minimum < 0 || begin == Begin::at_values) return false;
  return begin == Begin::at_zero || minimum == 0 || minimum < near_greatest * maximum;
}

Extent linear_extent(double minimum, double maximum, Begin begin) {
  const bool from_zero = begins_at_zero(minimum, maximum, begin);
  if (minimum == maximum) {
    const double room = minimum == 0 ? 1 : std::abs(minimum) / 10;
    return {from_zero ? 0 : minimum - room, maximum + room};
  }
  const double room = (from_zero && begin == Begin::at_zero ? maximum : maximum - minimum) * margin;
  if (from_zero) return {0, maximum + room};
  return {minimum - room, maximum + room};
}

Extent logarithmic_extent(double minimum, double maximum, bool has_zero) {
  const double room = minimum == maximum ? 2 : std::exp((std::log(maximum) - std::log(minimum)) * margin);
  return {minimum / room, maximum * room, true, has_zero};
}

}  // namespace

double Extent::fraction_along(double value) const {
  const double shown = std::clamp(value, -max_shown, max_shown);
  if (!is_logarithmic) return (shown - low) / (high - low);
  if (shown <= 0) return place_of_zero;
  const double begin = has_zero ? room_for_zero : 0;
  return begin + (1 - begin) * (std::log(std::max(shown, low)) - std::log(low)) / (std::log(high) - std::log(low));
}

std::vector<Tick> Extent::ticks(unsigned max_count, bool is_whole) const {
  if (!is_logarithmic) return linear_ticks(low, high, max_count, is_whole);
  std::vector<Tick> ticks = logarithmic_ticks(low, high, max_count, is_whole);
  if (has_zero) ticks.insert(ticks.begin(), {0, "0"});
  return ticks;
}

Extent make_extent(std::span<const double> values, Scale scale, Begin begin) {
  std::vector<double> finite;
  double min_positive = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    finite.push_back(std::clamp(value, -max_shown, max_shown));
    if (value > 0) min_positive = std::max(min_shown, min_positive == 0 ? value : std::min(min_positive, value));
  }
  if (finite.empty()) return {};
  const auto [minimum, maximum] = std::ranges::minmax(finite);
  if (is_logarithmic(finite, min_positive, scale))
    return logarithmic_extent(min_positive, std::max(maximum, min_positive), minimum == 0);
  return linear_extent(minimum, maximum, begin);
}

}  // namespace csgsim::plots
