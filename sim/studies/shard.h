// Shards: shares of the points of a study.
// Used to distribute a study over independent processes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::studies {

/// A share of the points of a study, measured by processes that do not communicate.
struct Shard {
  unsigned number = 1;  ///< from 1 to count
  unsigned count = 1;

  bool operator==(const Shard&) const = default;
};

inline constexpr unsigned max_shards = 1'000'000;

/// Parses `3/16`. Throws InputError that suggests a fix.
Shard parse_shard(std::string_view text);

std::string to_text(const Shard& shard);

/// Ascending numbers of points in the form `1,4-7`.
std::string ranges_text(const std::vector<unsigned>& ascending_numbers);

/// The number of the shard of each point. The points are shuffled in an order that depends only on their number, and
/// dealt out in turn: shard sizes differ by at most one point, and regularities of a study do not concentrate expensive
/// points in one shard.
std::vector<unsigned> assign_shards(std::size_t point_count, unsigned shard_count);

}  // namespace csgsim::studies
