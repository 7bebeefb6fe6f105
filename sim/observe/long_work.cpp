#include "sim/observe/long_work.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "hw/base/messages.h"

namespace csgsim::observe {

namespace {

std::string duration_text(double seconds) {
  constexpr double minute = 60;
  constexpr double hour = 60 * minute;
  if (seconds < 2 * minute) return fmt::format("{:.0f} seconds", seconds);
  if (seconds < 2 * hour) return fmt::format("{:.0f} minutes", seconds / minute);
  return fmt::format("{:.0f} hours", seconds / hour);
}

}  // namespace

Stopwatch wall_time() {
  return [] { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); };
}

LongWork::LongWork(std::string what, std::string remedy, Stopwatch stopwatch, double warning_threshold)
    : what_(std::move(what)),
      remedy_(std::move(remedy)),
      stopwatch_(std::move(stopwatch)),
      begin_(stopwatch_()),
      warning_threshold_(warning_threshold) {}

void LongWork::record_fraction(double fraction) {
  if (announced_seconds_ || !(fraction > 0)) return;
  const double expected = elapsed() / fraction;
  if (expected < warning_threshold_) return;
  announced_seconds_ = expected;
  report_line(fmt::format("warning: {} will take about {}, judging by the first {:.2g} %; {}", what_,
                          duration_text(expected), 100 * fraction, remedy_));
}

void LongWork::record_points(std::size_t done_points, std::size_t total_points) {
  constexpr double some_seconds = 5;
  constexpr double some_points = 0.05;
  const double part = static_cast<double>(done_points) / static_cast<double>(total_points);
  if (elapsed() >= some_seconds || part >= some_points) record_fraction(part);
}

}  // namespace csgsim::observe
