#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace csgsim::bench {

/// How often something is measured.
struct Rounds {
  unsigned most = 5;
  double seconds = 20;  ///< no further round begins when it has taken so long; the first always does
};

/// Something that is measured: does it once, and tells how many seconds that took.
using Timed = std::function<double()>;

/// Measures each once a round, in turn, so that what else the machine does meets all alike: A B C A B C. Returns each
/// one's median.
std::vector<double> medians_in_turn(std::span<const Timed> all, Rounds rounds);

double median(std::vector<double> values);

/// What another build takes for the same.
struct Other {
  double seconds = 0;  ///< median
  double ratio = 0;    ///< the other's seconds by these, of the same round: median of the rounds
};

struct Compared {
  double seconds = 0;  ///< median
  std::optional<Other> other{};
};

/// The same with another build beside it, A A' B B' A A' B B': `others` are as many as `all`, or none. A ratio of one
/// round is steady where the computer is faster in one round than in the next.
std::vector<Compared> compare_in_turn(std::span<const Timed> all, std::span<const Timed> others, Rounds rounds);

struct Point {
  double x = 0;
  double y = 0;
};

/// The power p of the law y = c x^p that fits best, by least squares of the logarithms. None for fewer than three
/// different x: any two points are of such a law, whether there is one or not.
std::optional<double> exponent(std::span<const Point> points);

}  // namespace csgsim::bench
