#include <cctype>

#include "places.h"
#include "sim/session/options/text_columns.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string cube = "cube(size = [8, 6, 4], center = true);\n";
const std::string broken = "cube(size = [8, 6, 4], center = true;\n";

/// Models that can be drawn, an unreadable one, an empty one, and files that corpus skips.
void make_models(const Folder& folder) {
  fs::create_directories(folder.path() / "models/deeper");
  write(folder / "models/a.csg", cube);
  write(folder / "models/b_broken.csg", broken);
  write(folder / "models/deeper/c.csg", "difference() { " + cube + "sphere($fn = 12, $fa = 12, $fs = 2, r = 3); }\n");
  write(folder / "models/nothing.csg", "group();\n");
  write(folder / "models/a.scad", "this is no OpenSCAD, and left out beside a.csg");
  write(folder / "models/notes.txt", "no model");
}

const std::vector<std::string> words{"corpus", "models", "--size",    "24x24", "--machines", "pixel-planes-4,scan-line",
                                     "-o",     "out",    "--threads", "2",     "--no-plots"};

nlohmann::json points(const Folder& folder) { return json(folder / "out/corpus.json")["points"]; }

}  // namespace

TEST_CASE("corpus skips models that it cannot draw with a reason each and exit code 1") {
  const Folder folder;
  make_models(folder);
  const Outcome outcome = run_words(words, folder.path());
  fails(outcome, 1, {"1 of 4 models could not be drawn: models/b_broken.csg; see corpus.csv for the reasons"});
  const nlohmann::json all = points(folder);
  REQUIRE(all.size() == 8);
  const std::vector<std::string> models{"models/a.csg", "models/b_broken.csg", "models/deeper/c.csg",
                                        "models/nothing.csg"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i]["model"] == models[i / 2]);
    CHECK(all[i]["machine"] == (i % 2 == 0 ? "pixel-planes-4" : "scan-line"));
  }
  CHECK(all[0]["halfspaces"] == 6);
  CHECK(all[0]["primitives"] == 1);
  CHECK(all[2]["reason"].get<std::string>().find("b_broken.csg:1:") != std::string::npos);
  CHECK(!all[2].contains("clocks"));
  CHECK(outcome.out.find("b_broken.csg:1:") != std::string::npos);
  const nlohmann::json clocks = json(folder / "out/corpus.json")["distributions"]["scan-line"]["clocks"];
  std::vector<double> three{all[1]["clocks"], all[5]["clocks"], all[7]["clocks"]};
  std::sort(three.begin(), three.end());
  CHECK(clocks["count"] == 3);
  CHECK(clocks["total"] == three[0] + three[1] + three[2]);
  CHECK(clocks["minimum"] == three[0]);
  CHECK(clocks["first_quartile"].get<double>() == doctest::Approx((three[0] + three[1]) / 2));
  CHECK(clocks["median"] == three[1]);
  CHECK(clocks["third_quartile"].get<double>() == doctest::Approx((three[1] + three[2]) / 2));
  CHECK(clocks["maximum"] == three[2]);
  // An empty model gives an empty picture.
  CHECK(all[6]["primitives"] == 0);
  CHECK(all[6]["render"] == 0);
}

TEST_CASE("each point of a corpus study has the counts that render reports") {
  const Folder folder;
  make_models(folder);
  run_words(words, folder.path());
  const nlohmann::json all = points(folder);
  for (const std::size_t i : {0U, 1U, 4U, 5U}) {
    const nlohmann::json& point = all[i];
    require_success(
        run_words({"render", point["model"], "--machine", point["machine"], "--size", "24x24", "--stats", "s.json"},
                  folder.path()));
    const nlohmann::json stats = json(folder / "s.json");
    CHECK(point["clocks"] == stats["clocks"]);
    CHECK(point["interval_clocks"] == stats["interval_clocks"]);
    CHECK(point["frames_per_second"] == stats["frames_per_second"]);
    CHECK(point["pixel_operations"] == stats["pixel_operations"]["total"]);
    CHECK(point["halfspaces"] == stats["model"]["halfspaces"]);
    CHECK(point["pieces"] == stats["model"]["pieces"]);
    CHECK(point["used_bits"] == stats["memory"]["used_bits"]);
    CHECK(point["bound_by"] == stats["bound_by"]["part"]);
    for (const auto& [purpose, cost] : stats["by_purpose"].items()) CHECK(point[purpose] == cost["clocks"]);
  }
}

TEST_CASE("corpus succeeds if one machine rejects a model that another draws") {
  const Folder folder;
  write(folder / "m.csg", cube);
  const Outcome outcome =
      run_words({"corpus", "m.csg", "--machines", "pixel-planes-4+array.memory_bits=30,pixel-planes-4", "--size",
                 "24x24", "-o", "out", "--no-plots"},
                folder.path());
  CHECK(outcome.code == 0);
  const nlohmann::json all = points(folder);
  REQUIRE(all.size() == 2);
  CHECK(all[0]["reason"].get<std::string>().find("memory bits") != std::string::npos);
  CHECK(all[1]["clocks"] > 0);
}

TEST_CASE("corpus resumes after an interruption and retries failed models") {
  const Folder folder;
  make_models(folder);
  run_words(words, folder.path());
  const std::string whole = content(folder / "out/corpus.csv");
  const std::string report = content(folder / "out/corpus.json");
  // Removes some lines and part of one: the same table must result.
  write(folder / "out/corpus.csv", whole.substr(0, whole.find("models/deeper/c.csg,scan-line") + 20));
  CHECK(run_words(words, folder.path()).code == 1);
  CHECK(content(folder / "out/corpus.csv") == whole);
  CHECK(content(folder / "out/corpus.json") == report);
  // Repairs the broken model, and replaces the empty one.
  write(folder / "models/b_broken.csg", cube);
  write(folder / "models/nothing.csg", cube);
  const Outcome repaired = require_success(run_words(words, folder.path()));
  CHECK(repaired.err.find("measured again") != std::string::npos);
  const nlohmann::json all = points(folder);
  CHECK(all[2]["clocks"] == all[0]["clocks"]);
  CHECK(all[7]["clocks"] == all[1]["clocks"]);
}

TEST_CASE("corpus rejects a folder without models") {
  const Folder folder;
  fs::create_directories(folder.path() / "empty");
  fails(run_words({"corpus", "empty", "-o", "out"}, folder.path()), 1, {"empty: contains no .csg, .scad or .jan file"});
}

TEST_CASE("corpus plots clocks and frames as PNG and SVG") {
  const Folder folder;
  write(folder / "m.csg", cube);
  require_success(run_words(
      {"corpus", "m.csg", "--machines", "pixel-planes-4,scan-line", "--size", "24x24", "-o", "out"}, folder.path()));
  for (const std::string name : {"corpus_clocks", "corpus_frames"}) {
    CHECK(content(folder / ("out/" + name + ".png")).substr(1, 3) == "PNG");
    CHECK(content(folder / ("out/" + name + ".svg")).find("</svg>") != std::string::npos);
  }
}

TEST_CASE("sweep skips an unreadable model with exit code 1 and retries it after a change") {
  const Folder folder;
  write(folder / "a.csg", cube);
  write(folder / "b.csg", broken);
  write(folder / "c.csg", "sphere($fn = 12, $fa = 12, $fs = 2, r = 3);\n");
  const std::vector<std::string> sweep{"sweep", "a.csg",      "b.csg",      "c.csg", "missing.csg", "--size",
                                       "24x24", "--strategy", "stack,list", "-o",    "out",         "--no-plots"};
  const Outcome outcome = run_words(sweep, folder.path());
  fails(outcome, 1, {"2 of 4 models could not be drawn: b.csg, missing.csg; see sweep.csv for the reasons"});
  nlohmann::json all = json(folder / "out/sweep.json")["points"];
  REQUIRE(all.size() == 8);
  CHECK(all[0]["clocks"] > 0);
  CHECK(all[2]["reason"].get<std::string>().starts_with("b.csg:1:"));
  CHECK(all[4]["clocks"] > 0);
  CHECK(outcome.out.find("\nb.csg:1:") != std::string::npos);
  const std::string table = content(folder / "out/sweep.csv");
  CHECK(run_words(sweep, folder.path()).code == 1);
  CHECK(content(folder / "out/sweep.csv") == table);
  write(folder / "b.csg", cube);
  write(folder / "missing.csg", cube);
  require_success(run_words(sweep, folder.path()));
  all = json(folder / "out/sweep.json")["points"];
  CHECK(all[2]["clocks"] == all[0]["clocks"]);
  CHECK(all[6]["clocks"] == all[0]["clocks"]);
}

TEST_CASE("columns of the corpus table are aligned with their headings for any name") {
  const Folder folder;
  write(folder / "a.csg", cube);
  std::string text = content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml");
  write(folder / "a-machine-of-a-name-that-is-longer-than-others.toml", text);
  const Outcome outcome =
      run_words({"corpus", "a.csg", "--size", "24x24", "--machines",
                 "pixel-planes-4,a-machine-of-a-name-that-is-longer-than-others.toml", "-o", "out", "--no-plots"},
                folder.path());
  REQUIRE(outcome.code == 0);
  std::istringstream lines(outcome.out);
  std::string heading;
  std::getline(lines, heading);
  const std::size_t end = heading.find("clocks") + 6;
  std::string line;
  std::getline(lines, line);
  CHECK(line == "a.csg: 1 primitive, 1 piece, 6 half-spaces");
  for (int machine = 0; machine < 2; ++machine) {
    std::getline(lines, line);
    CAPTURE(line);
    CHECK(std::isdigit(line.at(end - 1)) != 0);
    CHECK(line.at(end) == ' ');
    CHECK(line.find("  ", 4) < end);
  }
}

TEST_CASE("a table separates cells by two blanks and lets a row of one cell overflow") {
  const std::vector<std::vector<std::string>> rows{{"name", "n", "why"},
                                                   {"a line that is alone in its row"},
                                                   {"\u00e4", "123,456,789,012,345,678", "x"},
                                                   {"b", "not drawn"}};
  CHECK(csgsim::session::format_columns(rows, "<><") ==
        "name                        n  why\n"
        "a line that is alone in its row\n"
        "\u00e4     123,456,789,012,345,678  x\n"
        "b     not drawn\n");
}
