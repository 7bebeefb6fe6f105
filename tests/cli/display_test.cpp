#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

std::string display(const std::string& more) {
  return "display " + model("crossing_cylinders") +
         " --camera 300,-380,260,0,0,5 --projection perspective --size 48x36" + more;
}

}  // namespace

TEST_CASE("display counts every method and all exact methods see the same surfaces") {
  const Folder folder;
  const Outcome outcome = require_success(run(display(" --fragments 12,24 -o " + (folder / "d"))));
  CHECK(outcome.out.find("Exact methods see the same surfaces") != std::string::npos);
  const nlohmann::json points = json(folder / "d/display.json")["points"];
  REQUIRE(points.size() == 6 * 2);
  std::set<std::string> surfaces;
  for (const nlohmann::json& point : points) {
    CAPTURE(point["method"]);
    surfaces.insert(point["surfaces"].get<std::string>());
    CHECK(point["wrong"] == 0);
    CHECK(point["polygons"] == (point["fragments"] == 12 ? 28 : 52));
    const bool is_clipped = point["bucket_size"] == 24;
    CHECK((point["clipped_polygons"] > point["polygons"]) == is_clipped);
    const nlohmann::json& seconds = point["seconds"]["mc68000"];
    CHECK((seconds["preprocessing"] > 0) == is_clipped);
    CHECK(seconds["total"] > point["seconds"]["i486dx2"]["total"]);
    double sum = 0;
    for (const auto& [phase, one] : seconds.items()) sum += phase == "preprocessing" ? 0.0 : one.get<double>();
    CHECK(sum == doctest::Approx(2 * seconds["total"].get<double>()));
  }
  CHECK(surfaces.size() == 2);
  CHECK(fs::file_size(folder / "d/display.svg") > 1000);
}

TEST_CASE("display measures each tolerance and bucket size once") {
  const Folder folder;
  const std::string few = " --methods list-priority,scan-line --tolerances 2,0.5 --no-plots -o " + (folder / "d");
  require_success(run(display(few + " --bucket-sizes 6,24")));
  const nlohmann::json points = json(folder / "d/display.json")["points"];
  REQUIRE(points.size() == 6);
  CHECK(points[0]["tolerance"] == 2);
  CHECK(points[0]["polygons"] < points[1]["polygons"]);
  CHECK(points[0]["cells"] > points[2]["cells"]);
  CHECK(points[4]["bucket_size"] == 0);
  const std::string table = content(folder / "d/display.csv");
  require_success(run(display(few + " --bucket-sizes 6,24 --processors mc68000")));
  CHECK(content(folder / "d/display.csv") == table);
}

TEST_CASE("display counts the wrong pixels of list priority for coincident faces") {
  const Folder folder;
  write(folder / "level.csg",
        "difference() { cube(size = [4, 4, 4], center = true); cube(size = [2, 2, 4], center = true); }");
  const std::string command = "display " + (folder / "level.csg") +
                              " --size 64x48 --view-all --methods list-priority,list-priority/depth-buffer,scan-line "
                              "--processors mc68000 --no-plots -o " +
                              (folder / "d");
  const Outcome outcome = require_success(run(command));
  const nlohmann::json points = json(folder / "d/display.json")["points"];
  CHECK(points[0]["wrong"] > 0);
  CHECK(points[0]["wrong"] == points[0]["wrong_coincident"]);
  CHECK(points[1]["wrong"] == 0);
  CHECK(points[2]["wrong"] == 0);
  CHECK(outcome.out.find("coincident faces") != std::string::npos);
}

TEST_CASE("gathering two shards of display gives all points and bad options are rejected") {
  const Folder folder;
  const std::string common = " --methods scan-line,depth-lists --no-plots --progress none -o " + (folder / "s");
  require_success(run(display(common + " --shard 1/2")));
  require_success(run(display(common + " --shard 2/2")));
  require_success(run("gather " + (folder / "s")));
  CHECK(json(folder / "s/display.json")["points"].size() == 2);
  check_misuse(display(" --methods scanline"), "did you mean scan-line");
  check_misuse(display(" --bucket-sizes 0"), "--bucket-sizes");
  check_misuse(display(" --fragments 2"), "--fragments");
  check_misuse(display(" --curves exact --machine pixel-powers"), "--curves: this command supports facets only");
  require_success(run(display(" --machine pixel-powers --methods scan-line --no-plots -o " + (folder / "p"))));
}
