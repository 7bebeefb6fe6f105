#include "sim/report/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/report/number_text.h"

namespace csgsim::report {

namespace {

/// The least of 1, 2, 5 times a power of ten that is not below.
double nice_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  return 10.0 * power;
}

/// With so many digits that ticks of that step differ.
std::string tick_text(double value, double step) {
  const double clean = std::fabs(value) < step * 1e-6 ? 0.0 : value;
  if (step >= 1.0) return number_text(std::round(clean));
  if (step < 1e-4) {
    const double steps = std::max(1.0, std::fabs(clean) / step);
    return fmt::format("{:.{}g}", clean, static_cast<int>(std::ceil(std::log10(steps) + 1e-9)) + 1);
  }
  return fmt::format("{:.{}f}", clean, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

/// Powers of ten as `0.001` or `1e-7`, whichever people read at once.
std::string decade_text(double value) {
  if (value >= 1.0 && value < 1e9) return number_text(value);
  return value >= 1e-3 && value < 1.0 ? fmt::format("{:g}", value) : fmt::format("{:.0e}", value);
}

}  // namespace

Scale::Scale(const Axis& axis, std::span<const double> values, unsigned most_ticks) {
  if (!axis.names.empty()) {
    be_of_words(axis.names, most_ticks);
    return;
  }
  if (!values.empty()) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    low_ = *least;
    high_ = *most;
  }
  const bool has_positive = std::any_of(values.begin(), values.end(), [](double value) { return value > 0; });
  axis.logarithmic&& low_ >= 0 && has_positive ? be_logarithmic(values, most_ticks) : be_linear(values, most_ticks);
}

double Scale::at(double value) const {
  if (!is_logarithmic_) return (value - low_) / (high_ - low_);
  if (value <= 0) return 0;
  return zero_ + (1.0 - zero_) * (std::log10(value) - low_) / (high_ - low_);
}

void Scale::be_of_words(const std::vector<std::string>& names, unsigned most_ticks) {
  low_ = -0.5;
  high_ = static_cast<double>(names.size()) - 0.5;
  const std::size_t every = (names.size() + most_ticks - 1) / most_ticks;
  for (std::size_t i = 0; i < names.size(); i += every) ticks_.push_back({at(static_cast<double>(i)), names[i]});
}

void Scale::be_linear(std::span<const double> values, unsigned most_ticks) {
  if (low_ > 0 && low_ < 0.3 * high_) low_ = 0;
  if (low_ == high_) {
    low_ = std::min(0.0, low_);
    high_ = std::max(high_, low_ + 1.0);
  }
  const bool is_whole =
      std::all_of(values.begin(), values.end(), [](double value) { return value == std::floor(value); });
  const double step = std::max(nice_step((high_ - low_) / most_ticks), is_whole ? 1.0 : 0.0);
  low_ = std::floor(low_ / step + 1e-9) * step;
  high_ = std::ceil(high_ / step - 1e-9) * step;
  for (int i = 0; low_ + i * step <= high_ + step / 2; ++i) {
    const double value = low_ + i * step;
    ticks_.push_back({at(value), tick_text(value, step)});
  }
}

void Scale::be_logarithmic(std::span<const double> values, unsigned most_ticks) {
  is_logarithmic_ = true;
  double least = high_;
  for (const double value : values)
    if (value > 0) least = std::min(least, value);
  constexpr double room_for_zero = 0.12;
  zero_ = low_ == 0 ? room_for_zero : 0.0;
  // Within a decade or two, ticks at 1, 2 and 5 leave less of the axis empty.
  const bool is_short = std::log10(high_ / least) < 2.0;
  const auto floor_of = [&](double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
    if (!is_short) return power;
    return value >= 5 * power * (1 - 1e-9) ? 5 * power : value >= 2 * power * (1 - 1e-9) ? 2 * power : power;
  };
  const double bottom = floor_of(least);
  const double top = is_short ? nice_step(high_) : nice_step(std::pow(10.0, std::ceil(std::log10(high_) - 1e-9)));
  low_ = std::log10(bottom);
  high_ = top > bottom * (1 + 1e-9) ? std::log10(top) : low_ + 1.0;
  std::vector<double> marks;
  for (int decade = static_cast<int>(std::floor(low_ + 1e-9)); decade <= std::floor(high_ + 1e-9); ++decade) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10.0, decade);
      const double place = std::log10(value);
      if ((factor == 1.0 || is_short) && place >= low_ - 1e-9 && place <= high_ + 1e-9) marks.push_back(value);
    }
  }
  if (zero_ > 0) ticks_.push_back({0.0, "0"});
  const std::size_t every = std::max<std::size_t>(1, (marks.size() + most_ticks) / (most_ticks + 1));
  for (std::size_t i = 0; i < marks.size(); i += every) ticks_.push_back({at(marks[i]), decade_text(marks[i])});
}

}  // namespace csgsim::report
