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

/// Clocks of one part of a machine by what it did in them. `Activity` is an enum whose values are 0 to `activities`
/// - 1.
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

/// As it is told of that part: these activities, or all if none is named.
template <class Activity, std::size_t activities>
PartAccount part_of(std::string part, const ClockTally<Activity, activities>& tally,
                    const std::array<std::string_view, activities>& names, std::initializer_list<Activity> told = {}) {
  PartAccount account{std::move(part), {}};
  const auto tell = [&](std::size_t i) { account.clocks.push_back({names.at(i), tally.clocks.at(i)}); };
  for (const Activity activity : told) tell(static_cast<std::size_t>(activity));
  for (std::size_t i = 0; told.size() == 0 && i < activities; ++i) tell(i);
  return account;
}

}  // namespace csgsim::machines
