#include "sim/studies/sensitivity/samples.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "hw/base/hash.h"

namespace csgsim::studies {

namespace {

constexpr std::int64_t max_linear_ratio = 4;

/// The standard defines the numbers of the engine but not those of its distributions.
double next_position(std::mt19937_64& engine) { return std::ldexp(static_cast<double>(engine() >> 32U), -32); }

std::mt19937_64 engine_of(std::string_view key, std::uint32_t seed) {
  Hash hash;
  hash.add(key);
  return std::mt19937_64(hash.value() ^ seed);
}

}  // namespace

std::vector<double> strata(std::string_view key, std::uint32_t samples, std::uint32_t seed) {
  std::mt19937_64 engine = engine_of(key, seed);
  std::vector<double> positions;
  for (std::uint32_t i = 0; i < samples; ++i) positions.push_back((i + next_position(engine)) / samples);
  for (std::size_t left = positions.size(); left > 1; --left) {
    const auto other = static_cast<std::size_t>(next_position(engine) * static_cast<double>(left));
    std::swap(positions[left - 1], positions[other]);
  }
  return positions;
}

bool is_logarithmic(const RangedFigure& figure) {
  return figure.low > 0 && figure.high / figure.low >= max_linear_ratio && figure.high > max_linear_ratio * figure.low;
}

std::int64_t value_at(const RangedFigure& figure, double position) {
  const auto low = static_cast<double>(figure.low);
  const double end = static_cast<double>(figure.high) + 1;
  const double value = is_logarithmic(figure) ? low * std::pow(end / low, position) : low + position * (end - low);
  return std::clamp(static_cast<std::int64_t>(std::floor(value)), figure.low, figure.high);
}

}  // namespace csgsim::studies
