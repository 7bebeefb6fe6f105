// Statistics of a frame by part and activity.
// Used by hw, sim/engine and sim/observe.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::machines {

/// Clocks that a part of a machine spent in one activity.
struct ActivityClocks {
  std::string_view activity;
  std::uint64_t clocks = 0;

  constexpr bool operator==(const ActivityClocks&) const = default;
};

/// Activities of one part of a machine. Each clock of the frame counts for exactly one.
struct PartAccount {
  std::string part;
  std::vector<ActivityClocks> clocks;

  bool operator==(const PartAccount&) const = default;
};

/// A named count.
struct Count {
  std::string name;
  std::uint64_t value = 0;

  bool operator==(const Count&) const = default;
};

/// A ratio of two counts.
struct Share {
  std::string_view name;
  std::uint64_t part = 0;
  std::uint64_t whole = 0;

  constexpr bool operator==(const Share&) const = default;

  /// The ratio; 0 if `whole` is 0.
  [[nodiscard]] constexpr double value() const {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// Statistics of a frame in addition to its clocks, defined by the kind of the machine.
struct Account {
  std::vector<Count> counts;
  std::vector<Share> shares;
  std::vector<PartAccount> parts;

  bool operator==(const Account&) const = default;

  /// The count with that name. Throws std::out_of_range if there is none.
  [[nodiscard]] std::uint64_t count(std::string_view name) const;
};

}  // namespace csgsim::machines
