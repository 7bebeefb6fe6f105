/// Fails the n-th write, fsync, rename, ... of a shard, one at a time: the shard must resume from the remains.

#include "tests/cli/cli.h"
#include "tests/faults/child.h"

namespace {

using csgsim::testing::cli::content;
using csgsim::testing::cli::Folder;
using csgsim::testing::faults::calls;
using csgsim::testing::faults::ChildResult;
using csgsim::testing::faults::run_csgsim;
using csgsim::testing::faults::run_with_faults;

std::vector<std::string> sweep(const std::string& out, const std::vector<std::string>& more) {
  std::vector<std::string> words{
      "sweep", csgsim::testing::cli::model("old_example011"), "--size", "8x8", "--threads", "1", "--no-plots", "-o",
      out};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Number of files with the names of incomplete files.
std::size_t partial_files(const fs::path& folder) {
  std::size_t count = 0;
  if (!fs::exists(folder)) return 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename().native().starts_with(".csgsim-")) ++count;
  return count;
}

}  // namespace

TEST_CASE("a shard leaves complete rows after any failing call and resumes from them") {
  const Folder folder;
  const std::string report = folder / "report";
  const std::string out = folder / "out";
  REQUIRE(run_csgsim(sweep(folder / "one", {}), {}).code == 0);
  const std::string wanted = content(folder / "one/sweep.csv");
  REQUIRE(run_with_faults(sweep(folder / "counted", {"--shard", "1/1"}), "", report).code == 0);
  std::map<std::string, std::size_t> counts = calls(report);
  REQUIRE(counts["write"] >= 3);
  REQUIRE(counts["fsync"] >= 3);
  for (const std::string trial :
       {"write ENOSPC", "write SHORT", "fsync EIO", "rename EIO", "open EMFILE", "mkdir ENOSPC", "close EIO"}) {
    const std::string kind = trial.substr(0, trial.find(' '));
    // The last writes belong to the printed summary.
    for (std::size_t n = 1; n <= std::min<std::size_t>(counts[kind], 5); ++n) {
      const std::string fault = kind + ":" + std::to_string(n) + ":" + trial.substr(kind.size() + 1);
      CAPTURE(fault);
      fs::remove_all(out);
      fs::remove(report);
      const ChildResult ended = run_with_faults(sweep(out, {"--shard", "1/1"}), fault, report);
      CAPTURE(ended.err);
      CHECK(content(report).starts_with("failed "));
      CHECK(ended.code == 1);
      CHECK(csgsim::testing::cli::is_one_line(ended.err));
      CHECK(partial_files(out) == 0);
      REQUIRE(run_csgsim(sweep(out, {"--shard", "1/1"}), {}).code == 0);
      REQUIRE(run_csgsim({"gather", out, "--no-plots"}, {}).code == 0);
      CHECK(content(out + "/sweep.csv") == wanted);
    }
  }
}
