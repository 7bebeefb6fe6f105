#pragma once

#include <cstddef>
#include <cstdint>
#include <systemc>

#include "hw/machines/clock_tally.h"
#include "hw/machines/machine.h"
#include "hw/systemc/kernel.h"

namespace csgsim::multi_processor {

/// The common clock of all units. Its edges are not simulated: a unit sleeps for a whole number of clocks while no
/// other unit affects its work.
class TimeBase {
 public:
  explicit TimeBase(const machines::Machine& machine) : period_(systemc::period_of(machine)) {}

  /// Clocks since the simulation began.
  [[nodiscard]] std::uint64_t now() const { return systemc::edges(period_); }

  /// Duration of that number of clocks.
  [[nodiscard]] sc_core::sc_time of(std::uint64_t clocks) const {
    return sc_core::sc_time::from_value(clocks * period_.value());
  }

 private:
  sc_core::sc_time period_;
};

/// Counts a unit's clocks by activity.
template <class Activity, std::size_t activities>
class ActivityCounter {
 public:
  void begin(Activity first, std::uint64_t now) {
    clocks_ = {};
    activity_ = first;
    since_ = now;
  }

  /// Changes the activity from clock `now` on, which must not precede the last change.
  void change(Activity next, std::uint64_t now) {
    clocks_.add(activity_, now - since_);
    activity_ = next;
    since_ = now;
  }

  [[nodiscard]] Activity now() const { return activity_; }

  /// Clocks since the last change.
  [[nodiscard]] std::uint64_t since(std::uint64_t now) const { return now - since_; }

  /// Clocks by activity up to `now`.
  [[nodiscard]] machines::ClockTally<Activity, activities> clocks(std::uint64_t now) const {
    machines::ClockTally<Activity, activities> all = clocks_;
    all.add(activity_, now - since_);
    return all;
  }

 private:
  machines::ClockTally<Activity, activities> clocks_;
  Activity activity_{};
  std::uint64_t since_ = 0;
};

}  // namespace csgsim::multi_processor
