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
  CHECK(compiled("--pruning auto") == compiled(""));
  CHECK(compiled("--pruning none") != compiled(""));
  CHECK(compiled("--pruning space+picture+separation+halfspaces+near") ==
        compiled("--pruning no-hidden+no-sets+no-early-out"));
  CHECK(compiled("--pruning early-out") != compiled("--pruning none"));
}

TEST_CASE("--pruning auto equals all where the host is ideal") {
  const std::string ideal = "--machine pixel-planes-4+host.processor=ideal ";
  CHECK(compiled(ideal + "--pruning auto") == compiled(ideal + "--pruning all"));
}

TEST_CASE("every machine draws the same picture with --pruning all, none and auto") {
  for (const char* const machine : {"pixel-planes-4", "pixel-planes-4+host.processor=ideal", "pixel-planes-5",
                                    "scan-line", "pixel-square+divider.kind=host", "pixel-powers"}) {
    const Folder folder;
    const auto drawn = [&](const std::string& pruning) {
      require_success(run("render " + model("old_example002") + " --size 48x48 --machine " + machine + " --pruning " +
                          pruning + " -o " + (folder / "p.ppm")));
      return content(folder / "p.ppm");
    };
    const std::string all = drawn("all");
    CHECK(drawn("auto") == all);
    CHECK(drawn("none") == all);
  }
}

TEST_CASE("render reports the tried and the omitted prunings and their cost") {
  const Folder folder;
  const std::string render = "render " + model("old_example002") + " --size 48x48 --verbose -o " + (folder / "p.ppm") +
                             " --stats " + (folder / "p.json");
  const Outcome paying = run(render);
  require_success(paying);
  CHECK(paying.out.find("pruning separation") != std::string::npos);
  CHECK(paying.out.find("whose test would take the host more than half of the time that its success saves") !=
        std::string::npos);
  const nlohmann::json prunings = json(folder / "p.json")["prunings"];
  CHECK(prunings["separation"]["left"] > 0);
  CHECK(prunings["separation"]["tried"] == 0);
  CHECK(prunings["space"]["host_nanoseconds"] > 0);
  require_success(run(render + " --pruning all"));
  const nlohmann::json all = json(folder / "p.json");
  CHECK(all["prunings"]["separation"]["tried"] > 0);
  CHECK(all["prunings"]["separation"]["left"] == 0);
  CHECK(all["host_model_clocks"] > 0);
}

TEST_CASE("rejects contradictory and unknown prunings") {
  check_misuse("render m.csg --pruning space+no-sets", "mixes prunings to apply and prunings to leave out");
  check_misuse("render m.csg --pruning space+", "there is no pruning ''");
  check_misuse("render m.csg --pruning no-spice", "did you mean no-space?");
}

TEST_CASE("sweep and diff accept the same names of prunings as render") {
  const Folder folder;
  const std::string part = model("old_example011") + " --size 16x16 ";
  require_success(run("sweep " + part + "--strategy stack --pruning all,none,no-sets+no-hidden,space --no-plots -o " +
                      (folder / "s")));
  const nlohmann::json points = json(folder / "s/sweep.json")["points"];
  REQUIRE(points.size() == 4);
  CHECK(points[2]["pruning"] == "no-sets+no-hidden");
  const Outcome diff = run("diff " + part + "--pruning-b none --no-stories");
  CHECK(diff.out.find("the first instruction that differs") != std::string::npos);
}
