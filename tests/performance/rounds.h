#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace csgsim::bench {

/// Number of repetitions of a measurement.
struct Rounds {
  unsigned most = 5;
  double seconds = 20;  ///< no further round begins after this time; the first always does
};

/// A measured function: runs once and returns its seconds.
using Timed = std::function<double()>;

/// Measures each function once per round, in turns, so that other load on the computer affects all equally: A B C A B
/// C. Returns the median of each.
std::vector<double> medians_in_turn(std::span<const Timed> all, Rounds rounds);

double median(std::vector<double> values);

/// Result of the other build.
struct Other {
  double seconds = 0;  ///< median
  double ratio = 0;    ///< median over the rounds of the other's seconds divided by these
};

struct Compared {
  double seconds = 0;  ///< median
  std::optional<Other> other{};
};

/// Measures in turns with another build, A A' B B' A A' B B'; `others` is as long as `all`, or empty. The ratio within
/// a round is stable even if the speed of the computer varies between rounds.
std::vector<Compared> compare_in_turn(std::span<const Timed> all, std::span<const Timed> others, Rounds rounds);

struct Point {
  double x = 0;
  double y = 0;
};

/// The exponent p of the best fit y = c x^p, by least squares of the logarithms. Empty for fewer than three different
/// x, because any two points fit such a law.
std::optional<double> exponent(std::span<const Point> points);

}  // namespace csgsim::bench
