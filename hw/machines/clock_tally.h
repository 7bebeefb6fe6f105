// Counts clocks by activity.
// Used by hw/multi_processor, hw/pixel_square and hw/scan_line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "hw/machines/accounts.h"

namespace csgsim::machines {

/// Clocks of one part of a machine by activity. `Activity` is an enum with the values 0 to `activities` - 1.
template <class Activity, std::size_t activities>
struct ClockTally {
  std::array<std::uint64_t, activities> clocks{};

  constexpr void add(Activity activity, std::uint64_t count = 1) {
    clocks[static_cast<std::size_t>(activity)] += count;
  }
  [[nodiscard]] constexpr std::uint64_t of(Activity activity) const {
    return clocks[static_cast<std::size_t>(activity)];
  }
  [[nodiscard]] constexpr std::uint64_t total() const {
    return std::accumulate(clocks.begin(), clocks.end(), std::uint64_t{0});
  }

  constexpr bool operator==(const ClockTally&) const = default;
};

/// The account of the part named `part`, with the activities in `listed`, or all if `listed` is empty.
template <class Activity, std::size_t activities>
PartAccount part_account(std::string part, const ClockTally<Activity, activities>& tally,
                         const std::array<std::string_view, activities>& names,
                         std::initializer_list<Activity> listed = {}) {
  PartAccount account{std::move(part), {}};
  const auto append = [&](std::size_t i) { account.clocks.push_back({names.at(i), tally.clocks.at(i)}); };
  for (const Activity activity : listed) append(static_cast<std::size_t>(activity));
  for (std::size_t i = 0; listed.size() == 0 && i < activities; ++i) append(i);
  return account;
}

}  // namespace csgsim::machines
