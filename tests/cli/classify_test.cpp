#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string few =
    " --methods standard,status,weave --coherences all-points,one-list --processors mc68000,i486dx2";

std::string classify(const std::string& more) {
  return "classify " + model("thesis_fig_2_3") + " --camera 42,-38,41,10,5.5,2 --size 48x36" + more;
}

}  // namespace

TEST_CASE("classify counts and prices every method and all see the same surfaces") {
  const Folder folder;
  const Outcome first = require_success(run(classify(" -o " + (folder / "c"))));
  CHECK(first.out.find("All methods see the same surfaces") != std::string::npos);
  const nlohmann::json points = json(folder / "c/classify.json")["points"];
  REQUIRE(points.size() == 7 * 6 + 3);
  std::set<std::string> surfaces;
  for (const nlohmann::json& point : points) {
    CAPTURE(point["method"]);
    surfaces.insert(point["surfaces"].get<std::string>());
    CHECK(point["seconds"]["mc68000"]["classification"] > point["seconds"]["i486dx2"]["classification"]);
    CHECK(point["seconds"]["mc68000"]["all"] >= point["seconds"]["mc68000"]["classification"]);
  }
  CHECK(surfaces.size() == 1);
  CHECK(fs::file_size(folder / "c/classify_balanced_none.svg") > 1000);
  // Simulates an interruption: removes the last line and half of the one before.
  const std::string table = content(folder / "c/classify.csv");
  const std::size_t last = table.rfind('\n', table.size() - 2);
  write(folder / "c/classify.csv", table.substr(0, table.rfind('\n', last - 1) + 30));
  require_success(run(classify(" -o " + (folder / "c"))));
  const std::string again = content(folder / "c/classify.csv");
  CHECK(again.substr(0, last - 200) == table.substr(0, last - 200));
}

TEST_CASE("classify prices stored counts for another processor without a new run") {
  const Folder folder;
  require_success(run(classify(few + " --no-plots -o " + (folder / "c"))));
  const std::string table = content(folder / "c/classify.csv");
  require_success(
      run(classify(" --methods standard,status,weave --coherences all-points,one-list --no-plots --processors "
                   "mc68000+price.load=24 -o " +
                   (folder / "c"))));
  CHECK(content(folder / "c/classify.csv") == table);
  const nlohmann::json dear = json(folder / "c/classify.json")["points"][0]["seconds"];
  REQUIRE(dear.size() == 1);
  CHECK(dear.begin().key() == "mc68000+price.load=24");
}

TEST_CASE("classify draws every supported tree shape and reports a tree that is too deep") {
  const Folder folder;
  const Outcome outcome =
      run(classify(" --shapes written,left-deep,balanced --reduced none,cells,inside --no-plots "
                   "--processors mc68000 -o " +
                   (folder / "c")));
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(json(folder / "c/classify.json")["points"].size() == 3 * (3 * 42 + 3));
  std::string deep = "union() {\n";
  for (int i = 0; i < 30; ++i)
    deep += "multmatrix([[1,0,0," + std::to_string(i) +
            "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { cube(size = [1,1,1], "
            "center = true); }\n";
  write(folder / "deep.csg", deep + "}\n");
  const Outcome refused =
      require_success(run("classify " + (folder / "deep.csg") +
                          " --size 32x32 --view-all --shapes written --methods standard,bit-parallel --coherences "
                          "one-list --processors mc68000 -o " +
                          (folder / "d")));
  CHECK(refused.out.find("use --shapes balanced") != std::string::npos);
  const Outcome alone = run(
      "classify " + (folder / "deep.csg") +
      " --size 32x32 --view-all --shapes written --methods bit-parallel --coherences one-list -o " + (folder / "e"));
  CHECK(alone.code == 1);
  CHECK(is_one_line(alone.err));
}

TEST_CASE("gathering two shards of classify gives all points") {
  const Folder folder;
  const std::string common = few + " --no-plots --progress none -o ";
  require_success(run(classify(common + (folder / "s") + " --shard 1/2")));
  require_success(run(classify(common + (folder / "s") + " --shard 2/2")));
  require_success(run("gather " + (folder / "s")));
  CHECK(json(folder / "s/classify.json")["points"].size() == 5);
}

TEST_CASE("classify rejects unknown names and suggests the nearest") {
  check_misuse("classify " + model("thesis_fig_2_3") + " --methods standrd", "did you mean standard");
  check_misuse("classify " + model("thesis_fig_2_3") + " --coherences onelist", "did you mean one-list");
  check_misuse("classify " + model("thesis_fig_2_3") + " --shapes round", "balanced");
  check_misuse("classify " + model("thesis_fig_2_3") + " --processors mc68001", "mc68000");
  check_misuse("compare " + model("thesis_fig_2_3") + " --with mc68000", "PROCESSOR:METHOD");
  check_misuse("compare " + model("thesis_fig_2_3") + " --with mc68000:weave/one-list", "no coherence");
}

TEST_CASE("compare lists software methods beside machines and all see equal surfaces") {
  const Folder folder;
  const Outcome outcome =
      require_success(run("compare " + model("thesis_fig_2_3") +
                          " --camera 42,-38,41,10,5.5,2 --machines pixel-planes-4,scan-line --sides 24,48 "
                          "--fragments none --with mc68000:status/one-list,this-computer:weave -o " +
                          (folder / "c")));
  CHECK(outcome.out.find("are identical on all machines") != std::string::npos);
  const nlohmann::json points = json(folder / "c/compare.json")["points"];
  REQUIRE(points.size() == 4 * 3);
  for (const nlohmann::json& point : points) {
    if (point["width"] == points[0]["width"]) CHECK(point["surfaces"] == points[0]["surfaces"]);
    CHECK(point["simulated_seconds"] > 0);
  }
  CHECK(points[6]["machine"] == "mc68000:status/one-list");
  CHECK(points[6]["bound_by"] == "ray intersection");
  CHECK(points[6]["simulated_seconds"] > points[0]["simulated_seconds"]);
}

TEST_CASE("the manual lists all processors or the named one and rejects unknown names") {
  const Outcome all = require_success(run("manual processors all"));
  CHECK(all.out.find("mc68000\n") != std::string::npos);
  CHECK(all.out.find("i486dx2\n") != std::string::npos);
  const Outcome one = require_success(run("manual processors mc68000"));
  CHECK(one.out.find("price.load_long") != std::string::npos);
  CHECK(one.out.find("i486dx2") == std::string::npos);
  check_misuse("manual processors mc68001", "did you mean mc68000");
  CHECK(run("manual methods").out.find("csg-buffer") != std::string::npos);
}

TEST_CASE("the rays exported by classify reproduce its counts") {
  const Folder folder;
  require_success(run(classify(few + " --json " + (folder / "rays.json") + " -o " + (folder / "c"))));
  const nlohmann::json point = json(folder / "c/classify.json")["points"][0];
  const nlohmann::json rays = json(folder / "rays.json");
  CHECK(rays["width"] == 48);
  CHECK(rays["height"] == 36);
  CHECK(rays["primitives"] == point["primitives"]);
  std::uint64_t hits = 0;
  std::uint64_t sequences = 0;
  std::uint64_t points = 0;
  std::vector<std::uint64_t> last;
  std::set<std::vector<std::uint64_t>> different;
  std::set<std::set<std::uint64_t>> combinations;
  for (const nlohmann::json& ray : rays["rays"]) {
    const bool is_hit = !ray["seen"].is_null();
    hits += is_hit ? 1U : 0U;
    std::vector<std::uint64_t> sequence;
    std::set<std::uint64_t> depths;
    for (const nlohmann::json& event : ray["events"]) {
      if (is_hit && event[0] > ray["seen"][0]) break;
      sequence.push_back(event[1]);
      depths.insert(event[0].get<std::uint64_t>());
    }
    points += depths.size();
    if (sequences == 0 || sequence != last) ++sequences;
    last = sequence;
    different.insert(sequence);
    combinations.emplace(sequence.begin(), sequence.end());
  }
  CHECK(rays["rays"].size() == point["met_rays"]);
  CHECK(hits == point["hit_rays"]);
  CHECK(points == point["points"]);
  CHECK(sequences == point["sequences"]);
  CHECK(different.size() == point["different_sequences"]);
  CHECK(combinations.size() == point["combinations"]);
  check_misuse(classify(" --json " + model("thesis_fig_2_3")), "");
}
