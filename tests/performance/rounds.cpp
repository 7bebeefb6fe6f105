#include "tests/performance/rounds.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <stdexcept>
#include <utility>

namespace csgsim::bench {

double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("no values have no median");
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

namespace {

/// Seconds of each measurement, one row each, one column per round.
std::vector<std::vector<double>> times_in_turn(std::span<const Timed> all, Rounds rounds) {
  std::vector<std::vector<double>> taken(all.size());
  const auto begin = std::chrono::steady_clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  for (unsigned round = 0; round == 0 || (round < rounds.most && passed() < rounds.seconds); ++round) {
    for (std::size_t i = 0; i < all.size(); ++i) taken[i].push_back(all[i]());
  }
  return taken;
}

Other other_of(const std::vector<double>& own, const std::vector<double>& others) {
  std::vector<double> ratios(own.size());
  std::transform(others.begin(), others.end(), own.begin(), ratios.begin(), std::divides<>());
  return {median(others), median(std::move(ratios))};
}

}  // namespace

std::vector<double> medians_in_turn(std::span<const Timed> all, Rounds rounds) {
  std::vector<double> medians;
  for (std::vector<double>& one : times_in_turn(all, rounds)) medians.push_back(median(std::move(one)));
  return medians;
}

std::vector<Compared> compare_in_turn(std::span<const Timed> all, std::span<const Timed> others, Rounds rounds) {
  const bool beside = !others.empty();
  std::vector<Timed> order;
  for (std::size_t i = 0; i < all.size(); ++i) {
    order.push_back(all[i]);
    if (beside) order.push_back(others[i]);
  }
  const std::vector<std::vector<double>> taken = times_in_turn(order, rounds);
  std::vector<Compared> compared;
  for (std::size_t i = 0; i < taken.size(); i += beside ? 2 : 1) {
    Compared& one = compared.emplace_back(Compared{median(taken[i])});
    if (beside) one.other = other_of(taken[i], taken[i + 1]);
  }
  return compared;
}

std::optional<double> exponent(std::span<const Point> points) {
  std::set<double> different;
  for (const Point& point : points) different.insert(point.x);
  if (different.size() < 3) return std::nullopt;
  double mean_x = 0;
  double mean_y = 0;
  for (const Point& point : points) {
    mean_x += std::log(point.x) / static_cast<double>(points.size());
    mean_y += std::log(point.y) / static_cast<double>(points.size());
  }
  double across = 0;
  double along = 0;
  for (const Point& point : points) {
    const double x = std::log(point.x) - mean_x;
    across += x * (std::log(point.y) - mean_y);
    along += x * x;
  }
  return across / along;
}

}  // namespace csgsim::bench
