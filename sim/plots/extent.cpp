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
constexpr double least_shown = 1e-250;   ///< lower limit of a logarithmic axis, leaves room below
constexpr double largest_shown = 1e250;  ///< larger values are clamped to the edge, so that differences stay finite

bool is_logarithmic(std::span<const double> values, double least_positive, Scale scale) {
  if (scale == Scale::linear || least_positive == 0 || *std::ranges::min_element(values) < 0) return false;
  return scale == Scale::logarithmic || *std::ranges::max_element(values) / least_positive >= logarithmic_from;
}

bool begins_at_zero(double least, double most, Begin begin) {
  if (least < 0 || begin == Begin::at_values) return false;
  return begin == Begin::at_zero || least == 0 || least < near_greatest * most;
}

Extent linear_extent(double least, double most, Begin begin) {
  const bool from_zero = begins_at_zero(least, most, begin);
  if (least == most) {
    const double room = least == 0 ? 1 : std::abs(least) / 10;
    return {from_zero ? 0 : least - room, most + room};
  }
  const double room = (from_zero && begin == Begin::at_zero ? most : most - least) * margin;
  if (from_zero) return {0, most + room};
  return {least - room, most + room};
}

Extent logarithmic_extent(double least, double most, bool has_zero) {
  const double room = least == most ? 2 : std::exp((std::log(most) - std::log(least)) * margin);
  return {least / room, most * room, true, has_zero};
}

}  // namespace

double Extent::along(double value) const {
  const double shown = std::clamp(value, -largest_shown, largest_shown);
  if (!is_logarithmic) return (shown - low) / (high - low);
  if (shown <= 0) return place_of_zero;
  const double begin = has_zero ? room_for_zero : 0;
  return begin + (1 - begin) * (std::log(std::max(shown, low)) - std::log(low)) / (std::log(high) - std::log(low));
}

std::vector<Tick> Extent::ticks(unsigned most, bool is_whole) const {
  if (!is_logarithmic) return linear_ticks(low, high, most, is_whole);
  std::vector<Tick> ticks = logarithmic_ticks(low, high, most, is_whole);
  if (has_zero) ticks.insert(ticks.begin(), {0, "0"});
  return ticks;
}

Extent extent_of(std::span<const double> values, Scale scale, Begin begin) {
  std::vector<double> finite;
  double least_positive = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    finite.push_back(std::clamp(value, -largest_shown, largest_shown));
    if (value > 0)
      least_positive = std::max(least_shown, least_positive == 0 ? value : std::min(least_positive, value));
  }
  if (finite.empty()) return {};
  const auto [least, most] = std::ranges::minmax(finite);
  if (is_logarithmic(finite, least_positive, scale))
    return logarithmic_extent(least_positive, std::max(most, least_positive), least == 0);
  return linear_extent(least, most, begin);
}

}  // namespace csgsim::plots
