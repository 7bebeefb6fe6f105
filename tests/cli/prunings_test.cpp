#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

/// The Program of a model compiled with those options.
std::string compiled(const std::string& options) {
  const Folder folder;
  REQUIRE(run("compile " + model("old_example002") + " --size 60x50 " + options + " -o " + (folder / "p.csgt")).code ==
          0);
  return content(folder / "p.csgt");
}

}  // namespace

TEST_CASE("--pruning lists the prunings to apply or to omit") {
  CHECK(compiled("--pruning all") == compiled(""));
  CHECK(compiled("--pruning none") != compiled(""));
  CHECK(compiled("--pruning space+picture+separation+halfspaces+near") ==
        compiled("--pruning no-hidden+no-sets+no-early-out"));
  CHECK(compiled("--pruning early-out") != compiled("--pruning none"));
}

TEST_CASE("rejects contradictory and unknown prunings") {
  misused("render m.csg --pruning space+no-sets", "mixes prunings to apply and prunings to leave out");
  misused("render m.csg --pruning space+", "there is no pruning ''");
  misused("render m.csg --pruning no-spice", "did you mean no-space?");
}

TEST_CASE("sweep and diff accept the same names of prunings as render") {
  const Folder folder;
  const std::string part = model("old_example011") + " --size 16x16 ";
  succeeded(run("sweep " + part + "--strategy stack --pruning all,none,no-sets+no-hidden,space --no-plots -o " +
                (folder / "s")));
  const nlohmann::json points = json(folder / "s/sweep.json")["points"];
  REQUIRE(points.size() == 4);
  CHECK(points[2]["pruning"] == "no-sets+no-hidden");
  const Outcome diff = run("diff " + part + "--pruning-b none --no-stories");
  CHECK(diff.out.find("the first instruction that differs") != std::string::npos);
}
