#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

/// Writes a copy of a built-in machine's file with changed parameters, each given as "key value"; returns its path.
std::string machine_file(const Folder& folder, const std::string& name, const std::vector<std::string>& changes) {
  std::string text = content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/" + name + ".toml");
  for (const std::string& change : changes) {
    const std::size_t space = change.find(' ');
    const std::size_t at = text.find("\nvalue = ", text.find("[" + change.substr(0, space) + "]")) + 9;
    text.replace(at, text.find('\n', at) - at, change.substr(space + 1));
  }
  std::string path = folder / (name + "-changed.toml");
  write(path, text);
  return path;
}

struct Drawn {
  std::string picture;
  std::string depth;
  std::string owner;
  nlohmann::json stats;

  [[nodiscard]] bool same_pictures(const Drawn& other) const {
    return picture == other.picture && depth == other.depth && owner == other.owner;
  }
};

Drawn draw(const Folder& folder, const std::string& options) {
  require_success(run("render " + model("carburettor") + " --camera 220,-255,135,2,0,5 --size 75x50 -o " +
                      (folder / "p.ppm") + " --depth " + (folder / "d.exr") + " --owner " + (folder / "o.exr") +
                      " --stats " + (folder / "s.json") + " " + options));
  return {content(folder / "p.ppm"), content(folder / "d.exr"), content(folder / "o.exr"), json(folder / "s.json")};
}

std::uint64_t sum(const nlohmann::json& clocks) {
  std::uint64_t all = 0;
  for (const auto& [activity, count] : clocks.items()) all += count.get<std::uint64_t>();
  return all;
}

}  // namespace

TEST_CASE("both levels of every machine draw the same picture and predict the same clocks") {
  const Folder folder;
  const Drawn whole = draw(folder, "--machine pixel-planes-4");
  for (const std::string& machine :
       {std::string("scan-line"), std::string("pixel-square"), std::string("pixel-planes-5+evaluator.degree=1"),
        machine_file(folder, "scan-line",
                     {"chains.count 3", "refresh.interlaced 1", "cells.word_bits 16", "cells.words 6"}),
        machine_file(
            folder, "pixel-square",
            {"array.width 7", "array.height 9", "divider.order \"morton\"", "link.fifo_depth 1", "renderers.count 3"}),
        std::string("pixel-planes-5+evaluator.degree=1+divider.kind=host"),
        machine_file(folder, "pixel-planes-5",
                     {"divider.kind \"corners\"", "link.fifo_depth 1000", "renderers.buffers 1", "backing.bits 0"}),
        std::string("multi-processor"),
        machine_file(folder, "multi-processor",
                     {"nodes.columns 3", "nodes.rows 2", "rendering.order \"pixel\"", "display.divides_ahead 1",
                      "link.width 9", "node.word_bits 13", "node.program \"native\""}),
        machine_file(folder, "multi-processor",
                     {"node.memory_words 1500", "display.memory_words 12000", "refresh.bits 64",
                      "node.branches \"none\"", "lists.kind \"instructions\""})}) {
    CAPTURE(machine);
    const Drawn worked_out = draw(folder, "--machine " + machine);
    const Drawn counted = draw(folder, "--machine " + machine + " --level cycle");
    CHECK(worked_out.same_pictures(whole));
    CHECK(counted.same_pictures(whole));
    CHECK(worked_out.stats["clocks"] == counted.stats["clocks"]);
    CHECK(worked_out.stats["account"] == counted.stats["account"]);
  }
}

TEST_CASE("a multi-processor draws lists that exceed its nodes' memory in several passes") {
  const Folder folder;
  for (const char* const part : {"bolt_and_nut", "vase"}) {
    CAPTURE(part);
    const auto drawn = [&](const std::string& machine) {
      require_success(run("render " + std::string(CSGSIM_SOURCE_DIR) + "/tests/corpus/parts/" + part +
                          ".csg --size 128x128 --machine " + machine + " -o " + (folder / "p.ppm") + " --stats " +
                          (folder / "s.json")));
      return content(folder / "p.ppm");
    };
    const std::string whole = drawn("pixel-planes-4");
    CHECK(drawn("multi-processor+lists.kind=instructions") == whole);
    const nlohmann::json account = json(folder / "s.json")["account"];
    CHECK(account["list_passes"] > account["active_segments"]);
  }
}

TEST_CASE("each unit of the pixel-square machine accounts for all clocks of the frame") {
  const Folder folder;
  const Drawn drawn = draw(folder, "--machine " + machine_file(folder, "pixel-square", {"renderers.count 2"}));
  const nlohmann::json& account = drawn.stats["account"];
  for (const char* part : {"host", "renderer 0", "renderer 1", "frame buffer"}) {
    CHECK(sum(account["parts"].at(part)) == drawn.stats["clocks"]);
  }
  const auto count = [&](const char* name) { return account.at(name).get<int>(); };
  CHECK(count("squares of renderer 0") + count("squares of renderer 1") == count("squares_drawn"));
  CHECK(count("squares_drawn") + count("squares_skipped") == 5 * 4);
  CHECK(drawn.stats["segments"]["drawn"] == account["squares_drawn"]);
}

TEST_CASE("rejects a Program for another kind of machine and suggests a fix") {
  const Folder folder;
  const std::string program = folder / "p.csgt";
  require_success(run("compile " + model("carburettor") + " --size 64x48 --machine pixel-square -o " + program));
  require_success(run("run " + program + " --machine pixel-square --level cycle"));
  fails(run("run " + program + " --machine scan-line"), 1, {"compile the model for this one"});
  fails(run("render " + model("carburettor") + " --machine scan-line --size 600x20"), 1,
        {"600 pixels exceeds the 512 cells"});
}

TEST_CASE("compare draws a model on several machines and resumes after an interruption") {
  const Folder folder;
  const std::string command = "compare " + model("carburettor") + " --camera 220,-255,135,2,0,5 --size 48x40 -o " +
                              (folder / "c") + " --fragments 6,12 --sides 24,32";
  const Outcome first = require_success(run(command + " --machines pixel-planes-4,pixel-square"));
  CHECK(first.out.find("identical on all machines") != std::string::npos);
  const nlohmann::json points = json(folder / "c/compare.json")["points"];
  REQUIRE(points.size() == 2 * 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(points[i]["picture"] == points[i + 5]["picture"]);
    CHECK(points[i]["halfspaces"] == points[i + 5]["halfspaces"]);
    CHECK(points[i]["machine_transistors"] ==
          points[i]["processors"].get<std::uint64_t>() * points[i]["pixel_transistors"].get<std::uint64_t>());
    CHECK(points[i]["processor_clocks"] == points[i]["processors"].get<double>() * points[i]["clocks"].get<double>());
  }
  CHECK(points[5]["processors"] == 256);
  for (const char* plot :
       {"machines.png", "machines.svg", "halfspaces.png", "halfspaces.svg", "pixels.png", "pixels.svg"})
    CHECK(fs::file_size(folder / ("c/compare_" + std::string(plot))) > 1000);
  const std::string table = content(folder / "c/compare.csv");
  write(folder / "c/compare.csv", table.substr(0, table.size() - 40));
  require_success(run(command + " --machines pixel-planes-4,pixel-square --no-plots"));
  CHECK(content(folder / "c/compare.csv") == table);
  require_success(run(command + " --machines scan-line --no-plots"));
  CHECK(json(folder / "c/compare.json")["points"].size() == 5);
  CHECK(json(folder / "c/compare.json")["points"][0]["machine_transistors"].is_null());
  CHECK(run(command + " --machines nothing").code == 2);
}

TEST_CASE("compare names the parameter whose ideal value helps a machine most") {
  const Folder folder;
  const Outcome outcome =
      run("compare " + model("carburettor") + " --size 32x32 --machines pixel-planes-4 --ideal -o " + (folder / "c"));
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  std::string best;
  double most = 0;
  const nlohmann::json points = json(folder / "c/compare.json")["points"];
  for (const nlohmann::json& point : points) {
    const std::string ideal = point["ideal"];
    if (ideal.empty() || ideal == "all" || point["frames_per_second"] <= most) continue;
    best = ideal;
    most = point["frames_per_second"];
  }
  REQUIRE_FALSE(best.empty());
  CHECK(outcome.out.find("pixel-planes-4: ideal " + best + " gives ") != std::string::npos);
}

TEST_CASE("subdivide reports fewer remaining half-spaces at each smaller square") {
  const Folder folder;
  require_success(run("subdivide " + model("carburettor") + " --camera 220,-255,135,2,0,5 --size 128x128 -o " +
                      (folder / "s") + " --subdivisions 2,4,6 --no-plots"));
  const nlohmann::json columns = json(folder / "s/subdivide.json")["points"];
  REQUIRE(columns.size() == 3);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const nlohmann::json& segments = columns[i]["segments"];
    CHECK(segments["count"] == 4U << 2 * i);
    CHECK(columns[i]["subsegments"]["count"] == 64U << 2 * i);
    CHECK(segments["kept_halfspaces_mean"] <= segments["halfspaces_mean"]);
    CHECK(columns[i]["subsegments"]["kept_halfspaces_mean"] < segments["kept_halfspaces_mean"]);
    if (i > 0) CHECK(segments["kept_halfspaces_mean"] < columns[i - 1]["segments"]["kept_halfspaces_mean"]);
  }
  // The subsegments of four levels are the segments of eight.
  const Outcome eight =
      run("subdivide " + model("carburettor") + " --camera 220,-255,135,2,0,5 --size 128x128 -o " + (folder / "e") +
          " --subdivisions 8 --machine pixel-planes-5+divider.kind=corners --no-plots");
  REQUIRE(eight.code == 0);
  CHECK(json(folder / "e/subdivide.json")["points"][0]["segments"]["kept_halfspaces_mean"] ==
        columns[1]["subsegments"]["kept_halfspaces_mean"]);
  fails(run("subdivide " + model("carburettor") + " --machine scan-line"), 1,
        {"use a machine of kind pixel-square or multi-processor"});
}

TEST_CASE("subdivide resumes and adds levels and tolerances and writes plots and a page") {
  const Folder folder;
  const std::string subdivide = "subdivide " + model("carburettor") + " --size 64x64 -o " + (folder / "s");
  require_success(run(subdivide + " --subdivisions 2 --tolerances 1,0.5 --no-plots"));
  const std::string table = content(folder / "s/subdivide.csv");
  CHECK(
      table.starts_with("subdivisions,tolerance,model_hash,machine_hash,csgsim,primitives,halfspaces,segments_count,"));
  const std::string csv = folder / "s/subdivide.csv";
  write(csv, table.substr(0, table.size() - 40));
  require_success(run(subdivide + " --subdivisions 2 --tolerances 1,0.5 --no-plots"));
  CHECK(content(csv) == table);
  require_success(run(subdivide + " --subdivisions 2,3 --report " + (folder / "p.html")));
  CHECK(json(folder / "s/subdivide.json")["points"].size() == 2);
  CHECK(content(csv).ends_with(table.substr(table.find('\n') + 1)));
  for (const char* const file : {"s/subdivide.png", "s/subdivide.svg"}) CHECK(content(folder / file).size() > 1000);
  CHECK(content(folder / "p.html").find("Remaining work per square: ") != std::string::npos);
  CHECK(content(folder / "p.html").find("data-at=\"/points/1/subsegments/clocks\"") != std::string::npos);
}

TEST_CASE("subdivide's stage times of a multi-processor add up except for waiting") {
  const Folder folder;
  const std::string options = model("carburettor") + " --camera 220,-255,135,2,0,5 --size 128x128";
  const Outcome outcome =
      run("subdivide " + options + " --machine multi-processor --subdivisions 4,6 --no-plots -o " + (folder / "m"));
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.out.find("89.7       102.5       139.7") != std::string::npos);
  const nlohmann::json columns = json(folder / "m/subdivide.json")["points"];
  require_success(run("subdivide " + options + " --subdivisions 4,6 --no-plots -o " + (folder / "s")));
  const nlohmann::json squares = json(folder / "s/subdivide.json")["points"];
  for (std::size_t i = 0; i < 2; ++i) {
    const nlohmann::json& stages = columns[i]["stages"];
    const auto seconds = [&](const char* stage) { return stages["seconds"][stage].get<double>(); };
    const double sum = seconds("transformation") + seconds("first_pruning") + seconds("second_pruning") +
                       seconds("communication") + seconds("rendering");
    CHECK(sum < seconds("total"));
    CHECK(sum > 0.99 * seconds("total"));
    CHECK(seconds("scan_conversion") + seconds("classification") + seconds("depth_sort") < seconds("rendering"));
    CHECK(stages["first_halfspace_tests"] <= stages["halfspaces_touching"]);
    // Every machine that divides the picture in this way has the same segments and subsegments.
    for (const char* part : {"segments", "subsegments"}) {
      CHECK(columns[i][part]["count"] == squares[i][part]["count"]);
      CHECK(columns[i][part]["halfspaces_mean"] == squares[i][part]["halfspaces_mean"]);
      CHECK(squares[i][part].contains("instruction_clocks"));
      CHECK_FALSE(columns[i][part].contains("instruction_clocks"));
    }
    CHECK_FALSE(squares[i].contains("stages"));
  }
}
