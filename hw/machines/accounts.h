#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::machines {

/// Clocks that a part of a machine spent on one activity.
struct ActivityClocks {
  std::string_view activity;
  std::uint64_t clocks = 0;

  constexpr bool operator==(const ActivityClocks&) const = default;
};

/// Where one part of a machine spent the frame: every clock of it is in one of these.
struct PartAccount {
  std::string part;
  std::vector<ActivityClocks> clocks;

  bool operator==(const PartAccount&) const = default;
};

struct Count {
  std::string name;
  std::uint64_t value = 0;

  bool operator==(const Count&) const = default;
};

/// A part of a whole; of nothing it is 0.
struct Share {
  std::string_view name;
  std::uint64_t part = 0;
  std::uint64_t whole = 0;

  constexpr bool operator==(const Share&) const = default;

  [[nodiscard]] constexpr double value() const {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// How a frame went by on a machine, besides its clocks: what its kind has to tell.
struct Account {
  std::vector<Count> counts;
  std::vector<Share> shares;
  std::vector<PartAccount> parts;

  bool operator==(const Account&) const = default;

  /// The count of that name. Throws std::out_of_range if there is none.
  [[nodiscard]] std::uint64_t count(std::string_view name) const;
};

}  // namespace csgsim::machines
