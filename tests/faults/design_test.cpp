/// Fails the n-th write, fsync, rename, ... of a design, one at a time: the old or the new design must exist
/// afterwards.

#include "tests/cli/cli.h"
#include "tests/faults/child.h"

namespace {

using csgsim::testing::cli::content;
using csgsim::testing::cli::Folder;
using csgsim::testing::faults::ChildResult;
using csgsim::testing::faults::run_csgsim;
using csgsim::testing::faults::run_with_faults;

std::vector<std::string> design(const std::string& out, const std::string& size) {
  return {"rtl", "pixel-planes-4", csgsim::testing::cli::model("thesis_fig_2_3"), "--size", size, "-o", out, "--quiet"};
}

/// The contents of all files, by name.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder)] = content(entry.path());
  }
  return files;
}

}  // namespace

TEST_CASE("a failing call leaves the old or the new design and nothing else") {
  const Folder folder;
  const std::string report = folder / "report";
  for (const char* const size : {"4x4", "8x4"}) REQUIRE(run_csgsim(design(folder / size, size), {}).code == 0);
  const auto old = files_in(folder / "4x4");
  const auto wanted = files_in(folder / "8x4");
  REQUIRE(old != wanted);
  fs::create_directory(folder / "place");
  const std::string out = folder / "place/d";
  fs::copy(folder / "4x4", out, fs::copy_options::recursive);
  REQUIRE(run_with_faults(design(out, "8x4"), "", report).code == 0);
  std::map<std::string, std::size_t> counts = csgsim::testing::faults::calls(report);
  REQUIRE(counts["rename"] > old.size());
  for (const std::string trial :
       {"write ENOSPC", "write SHORT", "fsync EIO", "rename EIO", "mkdir ENOSPC", "open EMFILE"}) {
    const std::string kind = trial.substr(0, trial.find(' '));
    const std::size_t count = counts[kind];
    // The first calls, one in the middle and the last ones, which include the rename of the folder.
    for (const std::size_t n : {std::size_t{1}, std::size_t{2}, count / 2, count - 1, count}) {
      const std::string fault = kind + ":" + std::to_string(n) + ":" + trial.substr(kind.size() + 1);
      CAPTURE(fault);
      fs::remove_all(out);
      fs::remove(report);
      fs::copy(folder / "4x4", out, fs::copy_options::recursive);
      const ChildResult ended = run_with_faults(design(out, "8x4"), fault, report);
      CAPTURE(ended.err);
      CHECK(ended.signal == 0);
      const auto found = files_in(out);
      CHECK((found == old || found == wanted));
      if (ended.code != 0) {
        CHECK(ended.code == 1);
        CHECK(csgsim::testing::cli::is_one_line(ended.err));
      } else {
        CHECK(found == wanted);
      }
      CHECK(std::distance(fs::directory_iterator(folder / "place"), {}) == 1);
    }
  }
}
