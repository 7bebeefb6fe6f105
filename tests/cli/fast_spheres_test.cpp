#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string ball = "sphere($fn = 0, $fa = 12, $fs = 2, r = 10);\n";
const std::string small = " --size 64x64 --view-all --memory-bits 128 ";

std::string written(const Folder& folder, const std::string& csg) {
  write(folder / "model.csg", csg);
  return folder / "model.csg";
}

std::uint64_t clocks_of(const Folder& folder, const std::string& options) {
  require_success(run("render " + options + " --stats " + (folder / "s.json") + " -o " + (folder / "p.png")));
  return json(folder / "s.json")["clocks"];
}

}  // namespace

TEST_CASE("--curves fast draws a sphere in a tenth of the clocks on a linear machine") {
  const Folder folder;
  const std::string options = written(folder, ball) + " --view-all --memory-bits 128 --curves ";
  const std::uint64_t fast = clocks_of(folder, options + "fast");
  CHECK(clocks_of(folder, options + "facets") > 10 * fast);
  CHECK(run("render --help").out.find("fast (spheres as circles and paraboloids") != std::string::npos);
}

TEST_CASE("solids other than orthographic spheres stay facets with a single warning") {
  const Folder folder;
  const auto warnings = [&](const std::string& csg, const std::string& options) {
    const Outcome outcome =
        run("render " + written(folder, csg) + small + "--curves fast " + options + " -o " + (folder / "p.png"));
    CAPTURE(outcome.err);
    CHECK(outcome.code == 0);
    return outcome.err;
  };
  CHECK(warnings(ball, "").empty());
  CHECK(warnings("cube(size=[1,2,3]);\n", "").empty());
  const std::string three = ball + "multmatrix([[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {\n" + ball + "}\n" +
                            "cylinder($fn=0,$fa=12,$fs=2,h=30,r1=4,r2=4,center=true);\n";
  const std::string three_warnings = warnings(three, "");
  CHECK(is_one_line(three_warnings));
  CHECK(three_warnings.find("model.csg:3:1: warning: ") != std::string::npos);
  CHECK(three_warnings.find("this solid is an ellipsoid and is drawn as facets, as is 1 more curved solid") !=
        std::string::npos);
  CHECK(warnings(ball, "--projection p").find("is an ellipse in a perspective picture and is drawn as facets") !=
        std::string::npos);
  CHECK(warnings("sphere($fn=5,$fa=12,$fs=2,r=10);\n", "").empty());
}

TEST_CASE("--curves fast without a fast sphere compiles the Program of --curves facets") {
  const Folder folder;
  const auto program = [&](const std::string& curves, const std::string& csg, const std::string& options) {
    require_success(run("compile " + written(folder, csg) + small + options + " --curves " + curves + " -o " +
                        (folder / "p.csgt")));
    return content(folder / "p.csgt");
  };
  const std::string pocket = content(model("thesis_fig_2_3"));
  CHECK(program("fast", pocket, "") == program("facets", pocket, ""));
  CHECK(program("fast", ball, "--projection p") == program("facets", ball, "--projection p"));
  CHECK(program("fast", ball, "") != program("facets", ball, ""));
}

TEST_CASE("fast spheres and facets are seen by the same camera") {
  const Folder folder;
  const auto box = [&](const std::string& curves) {
    require_success(run("render " + written(folder, ball) + " --size 256x256 --view-all --memory-bits 128 --curves " +
                        curves + " --stats " + (folder / "s.json") + " -o " + (folder / "p.png")));
    return json(folder / "s.json")["camera"];
  };
  CHECK(box("fast") == box("facets"));
}

TEST_CASE("joined fast spheres fit 72 bits with 18 bits of depth and 18 of colour") {
  const Folder folder;
  const std::string options = "render " + model("molecule") + " --view-all --curves fast --z-bits 18 -o " +
                              (folder / "p.png") + " --colour-bits ";
  require_success(run(options + "18"));
  CHECK(run(options + "19").code == 1);
}

TEST_CASE("render suggests --curves facets where fast spheres are unsupported") {
  const Folder folder;
  const std::string options = "render " + written(folder, ball) + " --view-all --curves fast -o " + (folder / "p.png");
  fails(run(options), 1, {"17 squares", "--curves facets"});
  fails(run(options + " --machine pixel-square"), 1, {"draw facets with --curves facets"});
}
