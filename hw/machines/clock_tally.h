#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

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

}  // namespace csgsim::machines
