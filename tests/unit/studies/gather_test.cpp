#include "sim/studies/gather.h"

#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "places.h"
#include "tests/support/error_of.h"

using namespace csgsim;

namespace {

namespace fs = std::filesystem;

fs::path fresh_folder(const std::string& name) {
  fs::path folder = fs::path(CSGSIM_BINARY_DIR) / "scratch_gather" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// Returns the error of gathering two shards if the second has this number of points and these columns.
std::string refusal(const std::string& name, std::size_t points, const std::string& columns) {
  const fs::path folder = fresh_folder(name);
  studies::ShardHeader header{{1, 2}, 2, {"model", "machine", "csgsim"}, {"sweep"}};
  const std::vector<unsigned> shard_of = studies::assign_shards(2, 2);
  const std::size_t first = shard_of[0] == 1 ? 0 : 1;
  studies::ShardWriter(folder, header, {}, "a,b").add({first, "1,2"});
  header.shard.number = 2;
  header.points = points;
  studies::ShardWriter(folder, header, {}, columns).add({1 - first, "3,4"});
  const std::array<fs::path, 1> studies{folder};
  const std::string error = testing::error_of([&] { studies::merge_shards(studies); });
  fs::remove_all(folder);
  return error;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("gather rejects shards with different numbers of points or columns") {
  CHECK(refusal("alike", 2, "a,b").empty());
  CHECK(contains(refusal("points", 3, "a,b"), "not of the same study: the number of points changed between them"));
  CHECK(contains(refusal("columns", 2, "a,c"), "not of the same study: the columns changed between them"));
}

TEST_CASE("gather merges partial results of one shard from two processes") {
  const fs::path folder = fresh_folder("twice");
  const studies::ShardHeader header{{1, 1}, 3, {"model", "machine", "csgsim"}, {"sweep"}};
  studies::ShardWriter one(folder, header, {}, "a,b");
  one.add({0, "1,2"});
  one.add({1, "3,4"});
  studies::ShardWriter other(folder, header, {}, "a,b");
  other.add({1, "3,4"});
  other.add({2, "5,6"});
  const studies::MergedShards gathered = studies::merge_shards(std::array<fs::path, 1>{folder});
  CHECK(gathered.rows == std::vector<std::string>{"1,2", "3,4", "5,6"});
  CHECK(gathered.missing == 0);
  fs::remove_all(folder);
}
