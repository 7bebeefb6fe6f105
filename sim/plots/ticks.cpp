#include "sim/plots/ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/plots/number_text.h"

namespace csgsim::plots {

namespace {

/// A step of 1, 2 or 5 times a power of ten.
struct Step {
  int factor = 1;
  int exponent = 0;

  [[nodiscard]] double size() const { return factor * std::pow(10, exponent); }
  [[nodiscard]] Step next() const {
    if (factor == 5) return {1, exponent + 1};
    return {factor == 1 ? 2 : 5, exponent};
  }
};

/// The smallest step that fits at most `max_count` times into the range and is large enough for doubles of this size to
/// differ.
Step step_of(double low, double high, unsigned max_count) {
  const double largest = std::max(std::abs(low), std::abs(high));
  const double min_size = std::max((high - low) / max_count, 4 * std::numeric_limits<double>::epsilon() * largest);
  Step step{1, static_cast<int>(std::floor(std::log10(min_size))) - 1};
  while (step.size() < min_size) step = step.next();
  return step;
}

std::vector<Tick> with_texts(const std::vector<double>& values, const std::vector<std::string>& texts) {
  std::vector<Tick> ticks;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_new = std::ranges::none_of(ticks, [&](const Tick& tick) { return tick.text == texts[i]; });
    if (is_new) ticks.push_back({values[i], texts[i]});
  }
  return ticks;
}

struct Power {
  int factor = 1;
  int exponent = 0;
};

std::vector<Power> powers_between(double low, double high, const std::vector<int>& factors) {
  std::vector<Power> powers;
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  for (int exponent = static_cast<int>(std::floor(std::log10(low))); exponent <= last; ++exponent) {
    for (const int factor : factors) {
      const double value = factor * std::pow(10, exponent);
      if (value >= low && value <= high) powers.push_back({factor, exponent});
    }
  }
  return powers;
}

}  // namespace

std::vector<Tick> linear_ticks(double low, double high, unsigned max_count, bool is_whole) {
  Step step = step_of(low, high, max_count);
  if (is_whole && step.exponent < 0) step = {1, 0};
  std::vector<double> values;
  const double first = std::ceil(low / step.size());
  const auto count = static_cast<int>(std::max(0.0, std::floor(high / step.size()) - first + 1));
  for (int i = 0; i < count; ++i) {
    const double times = first + i;
    values.push_back(step.exponent < 0 ? times * step.factor / std::pow(10, -step.exponent) : times * step.size());
  }
  return with_texts(values, number_texts(values, step.exponent));
}

std::vector<Tick> logarithmic_ticks(double low, double high, unsigned max_count, bool is_whole) {
  std::vector<Power> powers = powers_between(low, high, {1});
  if (powers.size() < 3) {
    const std::vector<Power> more = powers_between(low, high, {1, 2, 5});
    if (more.size() <= max_count) powers = more;
  }
  if (is_whole) std::erase_if(powers, [](const Power& one) { return one.exponent < 0; });
  if (powers.size() < 2) return linear_ticks(low, high, max_count, is_whole);
  const std::size_t every = (powers.size() + max_count - 1) / max_count;
  const bool as_powers =
      std::ranges::any_of(powers, [](const Power& one) { return one.exponent < -4 || one.exponent > 6; });
  std::vector<double> values;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < powers.size(); i += every) {
    values.push_back(powers[i].factor * std::pow(10, powers[i].exponent));
    texts.push_back(power_text(powers[i].factor, powers[i].exponent, as_powers));
  }
  return with_texts(values, texts);
}

}  // namespace csgsim::plots
