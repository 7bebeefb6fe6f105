#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::studies {

/// One of the parts into which the points of a study are shared out, to be measured by processes that know nothing of
/// each other.
struct Shard {
  unsigned number = 1;  ///< from 1 to count
  unsigned count = 1;

  bool operator==(const Shard&) const = default;
};

inline constexpr unsigned most_shards = 1'000'000;

/// `3/16`. Throws InputError that says how it is mended.
Shard parse_shard(std::string_view text);

std::string to_text(const Shard& shard);

/// Numbers of points, ascending, as in `1,4-7`.
std::string compact(const std::vector<unsigned>& ascending);

/// The number of the shard that each of so many points belongs to. The points are put in an order that looks random and
/// depends on how many they are alone, and dealt out in turn: shards differ by one point at most, and no regularity of
/// a study gives one shard all that is dear.
std::vector<unsigned> shard_of_each(std::size_t points, unsigned shards);

}  // namespace csgsim::studies
