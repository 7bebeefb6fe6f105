#include "sim/studies/shard.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tests/support/error_of.h"

using namespace csgsim;
using studies::Shard;

TEST_CASE("a shard is parsed and printed as k/n and other forms are rejected") {
  CHECK(studies::parse_shard("1/1") == Shard{1, 1});
  CHECK(studies::parse_shard("3/16") == Shard{3, 16});
  CHECK(studies::to_text({3, 16}) == "3/16");
  for (const char* const text :
       {"", "/", "1/", "/1", "0/1", "2/1", "1/0", "1/2x", " 1/2", "+1/2", "1/2/2", "1/1000001"})
    CHECK_THROWS_AS(studies::parse_shard(text), InputError);
}

TEST_CASE("each point is in one shard and shards differ in size by at most one point") {
  for (const std::size_t points : {0U, 1U, 2U, 7U, 64U, 1000U}) {
    for (const unsigned shards : {1U, 2U, 3U, 16U, 999U}) {
      CAPTURE(points);
      CAPTURE(shards);
      const std::vector<unsigned> shard_of = studies::assign_shards(points, shards);
      REQUIRE(shard_of.size() == points);
      std::vector<std::size_t> counts(shards);
      for (const unsigned shard : shard_of) ++counts.at(shard - 1);
      const auto [fewest, most] = std::ranges::minmax(counts);
      CHECK(most - fewest <= 1);
    }
  }
}

TEST_CASE("points are distributed by SplitMix64 in every csgsim version") {
  // Results of an independent implementation: shards of a study in progress must not change.
  CHECK(studies::assign_shards(10, 3) == std::vector<unsigned>{2, 3, 1, 1, 2, 2, 3, 1, 1, 3});
}

TEST_CASE("expensive points at every tenth place are spread over ten shards") {
  const std::vector<unsigned> shard_of = studies::assign_shards(160, 10);
  std::vector<std::size_t> expensive(10);
  for (std::size_t i = 0; i < shard_of.size(); i += 10) ++expensive.at(shard_of[i] - 1);
  CHECK(std::ranges::max(expensive) <= 5);
}

TEST_CASE("shard numbers are printed as ranges") {
  CHECK(studies::ranges_text({}).empty());
  CHECK(studies::ranges_text({3}) == "3");
  CHECK(studies::ranges_text({1, 3, 4, 5, 9, 10}) == "1,3-5,9-10");
}
