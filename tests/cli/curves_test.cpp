#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string carburettor = model("carburettor") + " --camera 220,-255,135,2,0,5 --size 96x96 ";

}  // namespace

TEST_CASE("the most expensive primitives count a quadric once for any number of pieces") {
  const Folder folder;
  for (const std::string machine :
       {"pixel-powers", "pixel-square+evaluator.degree=2+divider.kind=host+array.memory_bits=128"}) {
    CAPTURE(machine);
    write(folder / "ball.csg", "sphere($fn = 32, $fa = 12, $fs = 2, r = 9);");
    require_success(run("render " + (folder / "ball.csg") + " --size 64x64 --curves exact --machine " + machine +
                        " --stats " + (folder / "s.json")));
    const auto stats = json(folder / "s.json");
    CHECK(stats["dearest"][0]["halfspaces"] == 1);
    CHECK(stats["model"]["halfspaces"] == 1);
  }
}

TEST_CASE("studies draw exact curved surfaces where the machine can and facets elsewhere") {
  const Folder folder;
  const std::string machines = "pixel-powers,pixel-planes-4";
  const Outcome corpus =
      require_success(run("corpus " + carburettor + "--machines " + machines + " --no-plots -o " + (folder / "c")));
  const auto counted = json(folder / "c/corpus.json")["points"];
  REQUIRE(counted.size() == 2);
  CHECK(counted[0]["halfspaces"] < 100);
  CHECK(counted[1]["halfspaces"] == 2038);
  const Outcome sweep =
      run("sweep " + carburettor + "--strategy stack,list --machines " + machines + " --no-plots -o " + (folder / "s"));
  REQUIRE(sweep.code == 0);
  CHECK(sweep.out.find("All pictures of a model with the same size, z bits and surfaces") != std::string::npos);
  const auto points = json(folder / "s/sweep.json")["points"];
  REQUIRE(points.size() == 4);
  CHECK(points[0]["picture"] == points[1]["picture"]);
  CHECK(points[2]["picture"] == points[3]["picture"]);
  CHECK(points[0]["picture"] != points[2]["picture"]);
  require_success(run("sweep " + carburettor + "--curves exact --strategy stack --machines " + machines +
                      " --no-plots -o " + (folder / "e")));
  const auto exact = json(folder / "e/sweep.json")["points"];
  CHECK(exact[0]["halfspaces"] < 100);
  CHECK(exact[1]["reason"].get<std::string>().find("pixel-planes-4 evaluates only linear expressions") !=
        std::string::npos);
}

TEST_CASE("sweep --curves varies the drawing of curves and reports memory and clocks") {
  const Folder folder;
  const Outcome sweep = require_success(run(
      "sweep " + carburettor + "--machines pixel-powers --strategy stack --curves facets,exact -o " + (folder / "s")));
  const auto points = json(folder / "s/sweep.json")["points"];
  REQUIRE(points.size() == 2);
  CHECK(points[0]["curves"] == "facets");
  CHECK(points[1]["curves"] == "exact");
  CHECK(points[1]["clocks"].get<int>() * 3 < points[0]["clocks"].get<int>());
  CHECK(points[1]["used_bits"] > points[0]["used_bits"]);
  for (const std::string field : {"sum", "root", "kept"}) {
    const auto& map = points[1]["memory_map"];
    CHECK(std::ranges::count_if(map, [&](const auto& one) { return one["name"] == field; }) == 1);
  }
  CHECK(fs::file_size(folder / "s/carburettor_clocks.svg") > 1000);
  CHECK(run("sweep " + carburettor + "--curves exactly -o " + (folder / "t")).code == 2);
}

TEST_CASE("compare has no option for curves because it draws the same facets everywhere") {
  const Folder folder;
  fails(run("compare " + carburettor + "--curves exact -o " + (folder / "c")), 2, {"--curves"});
}

TEST_CASE("subdivide counts quadrics among the half-spaces as render does") {
  const Folder folder;
  const std::string machine = " --machine pixel-square+evaluator.degree=2+divider.kind=host+array.memory_bits=128";
  require_success(run("subdivide " + carburettor + machine + " --subdivisions 2 --no-plots -o " + (folder / "s")));
  require_success(run("render " + carburettor + machine + " --stats " + (folder / "r.json")));
  CHECK(json(folder / "s/subdivide.json")["points"][0]["halfspaces"] == json(folder / "r.json")["model"]["halfspaces"]);
}

TEST_CASE("all levels and both forms of a Program draw the same curved surfaces") {
  const Folder folder;
  const std::string powers = carburettor + "--machine pixel-powers ";
  require_success(run("render " + powers + "-o " + (folder / "a.png")));
  require_success(run("compile " + powers + "-o " + (folder / "a.csgt")));
  REQUIRE(run("run " + (folder / "a.csgt") + " --machine pixel-powers --level cycle -o " + (folder / "b.png")).code ==
          0);
  CHECK(content(folder / "a.png") == content(folder / "b.png"));
  require_success(run("disasm " + (folder / "a.csgt") + " -o " + (folder / "text")));
  require_success(run("run " + (folder / "text") + " --machine pixel-powers -o " + (folder / "c.png")));
  CHECK(content(folder / "a.png") == content(folder / "c.png"));
  const Outcome diff = require_success(run("diff " + powers + "--level-a cycle --level-b reference"));
  CHECK(diff.out.find("the pictures are equal") != std::string::npos);
  require_success(run("effects " + powers + "--scene " + std::string(CSGSIM_SOURCE_DIR) +
                      "/tests/scenes/depth_cue.toml -o " + (folder / "e")));
  require_success(run("levels " + powers));
}

TEST_CASE("advise recommends settings for a quadratic machine with the stated accuracy") {
  const Folder folder;
  const Outcome outcome =
      require_success(run("advise " + model("thesis_fig_2_3") + " --camera 42,-38,41,10,5.5,2 --size 64x64 " +
                          "--machine pixel-powers --no-plots -o " + (folder / "a")));
  const std::size_t at = outcome.out.find("  csgsim render ");
  REQUIRE(at != std::string::npos);
  const std::string words = outcome.out.substr(at + 9, outcome.out.find('\n', at) - at - 9);
  require_success(run(words.substr(0, words.find(" --output")) + " --stats " + (folder / "s.json")));
  const auto stats = json(folder / "s.json");
  CHECK(stats["accuracy"]["unexplained"] == 0);
  CHECK(stats["accuracy"]["wrong"] <= 10);
}
