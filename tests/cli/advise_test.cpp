#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string narrow = " --size 64x48 --z-bits 12,14,16 --fraction-bits 2,6 --stack-bits 3,5 ";

/// Runs the recommended command and compares bits, clocks, rate and wrong pixels with the recommendation.
void check_command(const nlohmann::json& recommended, const Folder& folder) {
  std::string command = recommended["command"];
  CAPTURE(command);
  const std::string name = "csgsim ";
  REQUIRE(command.starts_with(name));
  const std::string output = " --output ";
  command.replace(command.find(output) + output.size(), std::string::npos, folder / "p.png");
  const Outcome outcome = run(command.substr(name.size()) + " --stats " + (folder / "p.json"));
  REQUIRE(outcome.err == "");
  REQUIRE(outcome.code == 0);
  const nlohmann::json stats = json(folder / "p.json");
  const nlohmann::json& point = recommended["point"];
  CHECK(stats["memory"]["used_bits"] == point["used_bits"]);
  CHECK(stats["clocks"] == point["clocks"]);
  CHECK(stats["interval_clocks"] == point["interval_clocks"]);
  CHECK(stats["frames_per_second"].get<double>() == doctest::Approx(point["frames_per_second"].get<double>()));
  CHECK(stats["accuracy"]["wrong"] == point["wrong"]);
}

/// All recommendations for the model, from advise.json.
nlohmann::json advice(const std::string& words, const Folder& folder) {
  require_success(run("advise " + model("old_example011") + words + " --no-plots -o " + (folder / "a")));
  return json(folder / "a/advise.json")["recommendations"];
}

}  // namespace

TEST_CASE("advise recommends commands that draw with the stated cost and accuracy") {
  const Folder folder;
  const nlohmann::json all = advice(narrow +
                                        "--projection perspective --alu-bits 1,4 --edge-on 0.01 --view-all "
                                        "--set lights.0.direction=0,0.5,-1 --pruning no-near+no-hidden --max-bits 80 "
                                        "--max-wrong-pixels 40 --min-colour-bits 15 --min-fps 30",
                                    folder);
  REQUIRE(all.size() == 4);
  for (const nlohmann::json& one : all) {
    CHECK(one["meets_all"] == true);
    check_command(one, folder);
  }
}

TEST_CASE("commands recommended under --quiet do not contain --quiet") {
  const Folder folder;
  for (const nlohmann::json& one : advice(narrow + "--max-wrong-pixels 1000 --quiet", folder))
    CHECK(one["command"].get<std::string>().find("--quiet") == std::string::npos);
}

TEST_CASE("the commands in docs/design-space.md draw what the page states") {
  const Folder folder;
  std::istringstream page(content(std::string(CSGSIM_SOURCE_DIR) + "/docs/design-space.md"));
  std::string figures;
  unsigned commands = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.find(" clocks, ") != std::string::npos && line.find("bits per pixel, ") != std::string::npos)
      figures = line;
    const std::size_t begin = line.find("csgsim render tests/");
    if (begin == std::string::npos) continue;
    ++commands;
    CAPTURE(line);
    const std::string output = " --output ";
    std::string words = line.substr(begin, line.find(output) - begin).substr(std::string("csgsim ").size());
    words.replace(words.find("tests/"), 0, std::string(CSGSIM_SOURCE_DIR) + "/");
    require_success(run(words + output + (folder / "p.png") + " --stats " + (folder / "p.json")));
    const nlohmann::json stats = json(folder / "p.json");
    const auto says = [&](const std::string& text) { return figures.find(text) != std::string::npos; };
    const std::string clocks = std::to_string(stats["clocks"].get<std::uint64_t>());
    CHECK(says(": " + stats["memory"]["used_bits"].dump() + " bits per pixel, "));
    CHECK(says(" " + stats["accuracy"]["wrong"].dump() + " wrong pixel"));
    CHECK(says(" " + clocks.substr(0, clocks.size() - 3) + "," + clocks.substr(clocks.size() - 3) + " clocks"));
  }
  CHECK(commands == 6);
}

TEST_CASE("the commands that advise recommends have the stated figures on every machine") {
  for (const std::string machine : {"scan-line", "pixel-square", "pixel-square+divider.kind=host", "multi-processor",
                                    "pixel-planes-4+scan_out.buffers=2"}) {
    CAPTURE(machine);
    const Folder folder;
    const nlohmann::json all = advice(
        " --size 48x48 --z-bits 12,16 --fraction-bits 2,6 --colour-bits 12,24 --stack-bits 3 "
        "--max-bits 120 --max-wrong-pixels 1000 --machine " +
            machine,
        folder);
    REQUIRE(all.size() == 4);
    check_command(all[0], folder);
    check_command(all[2], folder);
  }
}

TEST_CASE("advise names the conflicting limit and the nearest choice if none meets all") {
  const Folder folder;
  const std::string ask = "advise " + model("old_example011") + narrow + " --no-plots --max-wrong-pixels 1000 ";
  const Outcome fast = run(ask + "--min-fps 1e6 -o " + (folder / "a"));
  fails(fast, 1, {"no choice meets all requirements", "frames/s too few"});
  CHECK(fast.out.find("conflicting requirement: at least 1e+06 frames/s") != std::string::npos);
  CHECK(fast.out.find("rebroadcast") != std::string::npos);
  const nlohmann::json recommended = json(folder / "a/advise.json")["recommendations"];
  REQUIRE(recommended.size() == 1);
  CHECK(recommended[0]["what"] == "fastest");
  CHECK(recommended[0]["meets_all"] == false);
  check_command(recommended[0], folder);
  // No choice meets either of the two wishes, so there is no recommendation.
  const Outcome both = run(ask + "--min-fps 1e6 --max-bits 47 -o " + (folder / "a"));
  CHECK(both.code == 1);
  const nlohmann::json answer = json(folder / "a/advise.json");
  CHECK(answer["recommendations"].empty());
  CHECK(answer["meets_all"] == false);
  CHECK(both.out.find("nearest: ") != std::string::npos);
  check_command(answer["nearest"], folder);
  // 12 bits for each of two depths, 24 for colour and 1 for the mask.
  const Outcome tight = run(ask + "--max-bits 47 -o " + (folder / "b"));
  fails(tight, 1, {"2 bits too many"});
  CHECK(
      tight.out.find(
          "conflicting requirement: at least 24 bits of colour; with the others met, the best is 21 bits of colour") !=
      std::string::npos);
  require_success(run(ask + "--max-bits 49 -o " + (folder / "b")));
}

TEST_CASE("advise reuses its measurements when the limits change") {
  const Folder folder;
  const std::string ask =
      "advise " + model("old_example011") + narrow + "--colour-bits 12,24 --max-wrong-pixels 1000 -o " + (folder / "a");
  const Outcome first = run(ask + " --threads 2");
  CHECK(first.err == "");
  REQUIRE(first.code == 0);
  CHECK(fs::file_size(folder / "a/advise.png") > 1000);
  CHECK(fs::file_size(folder / "a/advise.svg") > 1000);
  const std::string table = content(folder / "a/advise.csv");
  const std::string answer = content(folder / "a/advise.json");
  // Simulates an interruption: removes some lines, one of them partly. The marked line must stay unchanged.
  const std::string measured = ",24,rebroadcast,stack,";
  std::string marked = table;
  const std::size_t at = marked.find(measured);
  REQUIRE(at != std::string::npos);
  const std::size_t end = marked.find('\n', at);
  marked.insert(end, "marked");
  write(folder / "a/advise.csv", marked.substr(0, marked.size() - 500));
  require_success(run(ask + " --threads 1 --no-plots"));
  CHECK(content(folder / "a/advise.csv") == marked);
  write(folder / "a/advise.csv", table);
  require_success(run(ask + " --min-fps 1 --max-bits 60 --no-plots"));
  CHECK(content(folder / "a/advise.csv") == table);
  CHECK(content(folder / "a/advise.json") != answer);
  const Outcome again = run(ask);
  CHECK(again.out == first.out);
  CHECK(content(folder / "a/advise.json") == answer);
  CHECK(run(ask + " --projection perspective").code == 1);
}

TEST_CASE("advise reports an edited table row whose figures differ from the drawn picture") {
  const Folder folder;
  const std::string ask =
      "advise " + model("old_example011") + narrow + "--max-wrong-pixels 1000 --no-plots -o " + (folder / "a");
  require_success(run(ask));
  std::string table = content(folder / "a/advise.csv");
  // Adds a wrong pixel to each row: a row ends with its clocks, wrong pixels and related counts.
  std::size_t changed = 0;
  for (std::size_t at = table.find(",0,0,"); at != std::string::npos; at = table.find(",0,0,", at + 1)) {
    table[at + 1] = '1';
    ++changed;
  }
  REQUIRE(changed > 0);
  write(folder / "a/advise.csv", table);
  fails(run(ask), 1,
        {"drawing a recommended choice gives another result than its row; rows read from the table "
         "may have been changed"});
}

TEST_CASE("advise without -o writes into a folder of the model's name and prints it last") {
  const Folder folder;
  const Outcome outcome = require_success(run_words({"advise", model("old_example011"), "--size", "32x32", "--z-bits",
                                                     "16", "--fraction-bits", "6", "--max-wrong-pixels", "1000"},
                                                    folder.path()));
  CHECK(outcome.out.find("\nfewest bits") != std::string::npos);
  CHECK(outcome.out.find("\nold_example011-advise: advise.csv, advise.json, and ") != std::string::npos);
  CHECK(folder.files() == 1);
  CHECK(fs::exists(folder / "old_example011-advise/advise.csv"));
}

TEST_CASE("advise rejects impossible limits and ranges before it measures") {
  const Folder folder;
  const std::string ask = "advise " + model("old_example011") + " -o " + (folder / "a") + " ";
  check_misuse(ask + "--max-bits 0", "--max-bits");
  check_misuse(ask + "--max-wrong-pixels -1", "whole number");
  check_misuse(ask + "--min-fps fast", "not a number");
  check_misuse(ask + "--min-fps=-2", "not a non-negative number");
  check_misuse(ask + "--min-colour-bits 25", "24");
  check_misuse(ask + "--strategy auto", "there is no strategy 'auto'");
  check_misuse(ask + "--strategy lst", "did you mean list?");
  check_misuse(ask + "--z-bits 3", "4 to 30");
  check_misuse(ask + "--fraction-bits 21", "0 to 20");
  check_misuse(ask + "--alu-bits 0", "1 to 32");
  check_misuse(ask + "--machine scan-line --alu-bits 2", "has no parameter alu.bits");
  check_misuse(ask + "--memory-bits 72", "--memory-bits");
  check_misuse("advise", "MODEL");
  CHECK(folder.files() == 0);
}
