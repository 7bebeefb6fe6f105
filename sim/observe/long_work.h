#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace csgsim::observe {

/// Seconds from some point in time on.
using Stopwatch = std::function<double()>;

Stopwatch wall_time();

/// Warns once on standard error, early, of work that will take minutes, by the time that its first part took.
class LongWork {
 public:
  static constexpr double few_seconds = 60;  ///< what takes less is not warned of

  /// `what` will take so long; `remedy` says what would take less.
  LongWork(std::string what, std::string remedy, Stopwatch stopwatch = wall_time(), double warned_of = few_seconds);

  /// This part of the work is done, above 0, at most 1.
  void at(double done);

  /// So many of the points of a study are done. The first read, compile and judge what the others share: nothing is
  /// foretold before some seconds, or some of the points.
  void at_point(std::size_t done, std::size_t points);

  /// Seconds in all that were warned of, if it was.
  [[nodiscard]] std::optional<double> warned() const { return warned_; }

  /// Seconds since the work began.
  [[nodiscard]] double elapsed() const { return stopwatch_() - begin_; }

 private:
  std::string what_;
  std::string remedy_;
  Stopwatch stopwatch_;
  double begin_;
  double warned_of_;
  std::optional<double> warned_;
};

}  // namespace csgsim::observe
