// Warns about work that will take minutes.
// Used by sim/observe, sim/session and sim/studies.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace csgsim::observe {

/// Returns seconds since some fixed point in time.
using Stopwatch = std::function<double()>;

/// A stopwatch that reads the steady clock of the system.
Stopwatch wall_time();

/// Warns once on standard error about work that will take minutes, judging by the time of its first part.
class LongWork {
 public:
  static constexpr double min_warned_seconds = 60;  ///< expected times below this cause no warning

  /// `what` names the work in the warning; `remedy` suggests how to shorten it.
  LongWork(std::string what, std::string remedy, Stopwatch stopwatch = wall_time(),
           double warning_threshold = min_warned_seconds);

  /// Records that this fraction of the work, above 0 and at most 1, is completed; may print the warning.
  void record_fraction(double fraction);

  /// Records the number of completed points of a study; may print the warning. The first points also read, compile and
  /// judge what the others share, so no estimate is made before some seconds or some points.
  void record_points(std::size_t done_points, std::size_t total_points);

  /// The expected total in seconds, if a warning was printed.
  [[nodiscard]] std::optional<double> announced_seconds() const { return announced_seconds_; }

  /// Seconds since the work began.
  [[nodiscard]] double elapsed() const { return stopwatch_() - begin_; }

 private:
  std::string what_;
  std::string remedy_;
  Stopwatch stopwatch_;
  double begin_;
  double warning_threshold_;
  std::optional<double> announced_seconds_;
};

}  // namespace csgsim::observe
