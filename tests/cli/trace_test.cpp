#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

std::string trace(const std::string& more) {
  return "trace " + model("thesis_fig_2_3") + " --camera 42,-38,41,10,5.5,2 --size 48x36" + more;
}

}  // namespace

TEST_CASE("trace counts and prices every directory with and without an item buffer") {
  const Folder folder;
  const Outcome first = require_success(run(trace(" -o " + (folder / "t"))));
  CHECK(first.out.find("All directories see the same surfaces") != std::string::npos);
  const nlohmann::json points = json(folder / "t/trace.json")["points"];
  REQUIRE(points.size() == 7 * 3 * 2);
  std::set<std::string> surfaces;
  for (const nlohmann::json& point : points) {
    CAPTURE(point["directory"]);
    CAPTURE(point["cast"]);
    surfaces.insert(point["surfaces"].get<std::string>());
    const nlohmann::json& seconds = point["seconds"]["mc68000"];
    double sum = 0;
    for (const char* const part : {"projection", "traversal", "intersection", "classification", "shading"})
      sum += seconds[part].get<double>();
    CHECK(seconds["all"].get<double>() == doctest::Approx(sum));
    CHECK(seconds["all"] > point["seconds"]["i486dx2"]["all"]);
    CHECK((point["shadow_rays"] > 0) == (point["cast"] != "primary"));
    CHECK((point["mirror_rays"] > 0) == (point["cast"] == "mirror"));
    const bool has_items = point["item_buffer"] == "list-priority";
    if (has_items && point["cast"] == "primary") CHECK(point["facet_tests"] == point["hit_rays"]);
    CHECK((seconds["projection"] > 0) == has_items);
    std::istringstream counts(point["rays_by_cells"].get<std::string>());
    std::uint64_t rays = 0;
    for (std::uint64_t count = 0; counts >> count;) rays += count;
    CHECK(point["rays"] == rays);
  }
  CHECK(surfaces.size() == 1);
  CHECK(fs::file_size(folder / "t/trace_cells.svg") > 1000);
  const std::string table = content(folder / "t/trace.csv");
  require_success(run(trace(" -o " + (folder / "t"))));
  CHECK(content(folder / "t/trace.csv") == table);
}

TEST_CASE("trace varies buckets and tolerances and plots each") {
  const Folder folder;
  const Outcome outcome =
      run(trace(" --directories excell --bucket-sizes 2,8 --cast primary --item-buffer without "
                "--mailboxes without,with --tolerances 1,0.1 --processors mc68000 -o " +
                (folder / "t")));
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  const nlohmann::json points = json(folder / "t/trace.json")["points"];
  REQUIRE(points.size() == 2 * 2 * 2);
  std::set<std::uint64_t> polygons;
  for (std::size_t i = 0; i < points.size(); i += 2) {
    polygons.insert(points[i]["polygons"].get<std::uint64_t>());
    CHECK(points[i]["repeats"] == 0);
    CHECK(points[i + 1]["repeats"] > 0);
    CHECK(points[i]["facet_tests"] ==
          points[i + 1]["facet_tests"].get<std::uint64_t>() + points[i + 1]["repeats"].get<std::uint64_t>());
  }
  CHECK(polygons.size() == 2);
  CHECK(fs::exists(folder / "t/trace_buckets.svg"));
  CHECK(fs::exists(folder / "t/trace_polygons.svg"));
}

TEST_CASE("gathering two shards of trace gives all points") {
  const Folder folder;
  const std::string common = " --directories excell,grid --cast primary --processors mc68000 --no-plots -o ";
  require_success(run(trace(common + (folder / "s") + " --shard 1/2")));
  require_success(run(trace(common + (folder / "s") + " --shard 2/2")));
  require_success(run("gather " + (folder / "s") + " --no-plots"));
  CHECK(json(folder / "s/trace.json")["points"].size() == 4);
}

TEST_CASE("trace rejects unknown names and suggests the nearest") {
  check_misuse(trace(" --directories excel"), "did you mean excell");
  check_misuse(trace(" --cast shadows"), "did you mean shadow");
  check_misuse(trace(" --cast light"), "the rays are primary");
  check_misuse(trace(" --curves exact --machine pixel-powers"), "--curves: this command supports facets only");
  check_misuse(trace(" --item-buffer wihtout"), "did you mean without");
  check_misuse(trace(" --bucket-sizes 0"), "1");
  check_misuse(trace(" --processors mc68001"), "mc68000");
  check_misuse(trace(" --reflections 5"), "4");
}

TEST_CASE("the exported directory has the counted cells and each corner in its cell") {
  const Folder folder;
  require_success(
      run(trace(" --directories excell --bucket-sizes 4 --cast primary --item-buffer without --processors mc68000 "
                "--json " +
                (folder / "cells.json") + " -o " + (folder / "t"))));
  const nlohmann::json point = json(folder / "t/trace.json")["points"][0];
  const nlohmann::json directory = json(folder / "cells.json");
  CHECK(directory["directory"] == "excell");
  std::uint64_t cells = 0;
  std::uint64_t references = 0;
  std::uint64_t corners_in_cells = 0;
  for (const nlohmann::json& part : directory["parts"]) {
    if (!part.contains("facets")) continue;
    ++cells;
    references += part["facets"].size();
    const std::set<std::uint64_t> held(part["facets"].begin(), part["facets"].end());
    for (std::uint64_t facet = 0; facet < directory["facets"].size(); ++facet) {
      for (const nlohmann::json& corner : directory["facets"][facet]["corners"]) {
        bool is_in = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          is_in = is_in && corner[axis] >= part["box"][0][axis].get<double>() &&
                  corner[axis] <= part["box"][1][axis].get<double>();
        }
        if (!is_in) continue;
        ++corners_in_cells;
        CHECK(held.contains(facet));
      }
    }
  }
  CHECK(cells == point["cells"]);
  CHECK(references == point["references"]);
  CHECK(corners_in_cells > 20);
}

TEST_CASE("trace adds the time of item buffers and of tests in the picture to projection") {
  const Folder folder;
  require_success(
      run(trace(" --directories kd-tree --cast primary --facet-test space,projected --item-buffer "
                "without,list-priority,depth-lists --processors mc68000 -o " +
                (folder / "t"))));
  require_success(
      run("display " + model("thesis_fig_2_3") +
          " --camera 42,-38,41,10,5.5,2 --size 48x36 --methods list-priority/depth-buffer --processors mc68000 -o " +
          (folder / "d")));
  const nlohmann::json drawn = json(folder / "d/display.json")["points"][0];
  const double total = drawn["seconds"]["mc68000"]["total"];
  const nlohmann::json points = json(folder / "t/trace.json")["points"];
  REQUIRE(points.size() == 6);
  for (const nlohmann::json& point : points) {
    CAPTURE(point["facet_test"]);
    CAPTURE(point["item_buffer"]);
    const double projection = point["seconds"]["mc68000"]["projection"];
    const double pointers = point["hit_rays"].get<double>() * 16 * 2 / 8e6;
    if (point["item_buffer"] == "list-priority") {
      CHECK(point["items"] == drawn["pixel_events"]);
      CHECK(point["item_faults"] == drawn["wrong"]);
    }
    if (point["facet_test"] != "space") {
      CHECK(projection > 0);
    } else if (point["item_buffer"] == "without") {
      CHECK(projection == 0);
    } else if (point["item_buffer"] == "list-priority") {
      CHECK(projection == doctest::Approx(total + pointers));
    }
  }
}
