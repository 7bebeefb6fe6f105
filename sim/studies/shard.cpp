#include "sim/studies/shard.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <numeric>
#include <optional>
#include <system_error>

#include "hw/base/error.h"

namespace csgsim::studies {

namespace {

std::optional<unsigned> parse_shard_number(std::string_view text) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014), a bijection.
std::uint64_t scramble(std::uint64_t number) {
  std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ z >> 30U) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ z >> 27U) * 0x94d049bb133111ebULL;
  return z ^ z >> 31U;
}

}  // namespace

Shard parse_shard(std::string_view text) {
  const std::size_t slash = text.find('/');
  const std::optional<unsigned> number = parse_shard_number(text.substr(0, slash));
  const std::optional<unsigned> count = slash < text.size() ? parse_shard_number(text.substr(slash + 1)) : std::nullopt;
  if (!number || !count)
    throw InputError(fmt::format("'{}' is not a shard; use k/n, such as 3/16 for the third of sixteen", text));
  if (*count < 1 || *count > max_shards)
    throw InputError(fmt::format("the number of shards must be from 1 to {}, not {}", max_shards, *count));
  if (*number < 1 || *number > *count)
    throw InputError(fmt::format("shard {} of {} does not exist; choose one of 1/{} to {}/{}", *number, *count, *count,
                                 *count, *count));
  return {*number, *count};
}

std::string to_text(const Shard& shard) { return fmt::format("{}/{}", shard.number, shard.count); }

std::string ranges_text(const std::vector<unsigned>& ascending_numbers) {
  std::string text;
  for (std::size_t first = 0; first < ascending_numbers.size();) {
    std::size_t last = first;
    while (last + 1 < ascending_numbers.size() && ascending_numbers[last + 1] == ascending_numbers[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", ascending_numbers[first]);
    if (last > first) text += fmt::format("-{}", ascending_numbers[last]);
    first = last + 1;
  }
  return text;
}

std::vector<unsigned> assign_shards(std::size_t point_count, unsigned shard_count) {
  std::vector<std::size_t> order(point_count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [](std::size_t a, std::size_t b) { return scramble(a) < scramble(b); });
  std::vector<unsigned> shard_of(point_count);
  for (std::size_t i = 0; i < point_count; ++i) shard_of[order[i]] = static_cast<unsigned>(i % shard_count) + 1;
  return shard_of;
}

}  // namespace csgsim::studies
