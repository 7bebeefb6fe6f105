#include "host/effects/rows.h"
#include "host/scene/schema.h"
#include "hw/kinds/rows.h"
#include "hw/machines/kind.h"
#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;
namespace effects = csgsim::effects;
namespace kinds = csgsim::kinds;
namespace machines = csgsim::machines;
namespace scene = csgsim::scene;

TEST_CASE("no machine parameter has the name of a scene key") {
  std::vector<std::string> words{"effects"};
  for (const scene::Section& section : scene::common_sections()) words.emplace_back(section.name);
  for (const scene::Section& section : effects::sections()) CHECK(section.name.starts_with("effects."));
  std::size_t figures = 0;
  for (const machines::Kind* kind : kinds::all()) {
    for (const machines::FigureSchema& figure : kind->schema) {
      const std::string word(figure.key.substr(0, figure.key.find('.')));
      CAPTURE(word);
      CHECK(std::ranges::find(words, word) == words.end());
      ++figures;
    }
  }
  CHECK(figures > 50);
}

TEST_CASE("--set KEY=VALUE selects the same machine as the name MACHINE+KEY=VALUE") {
  const Folder folder;
  const auto clocks = [&](const std::string& words) {
    REQUIRE(
        run("render " + model("old_example002") + " --size 32x32 " + words + " --stats " + (folder / "s.json")).code ==
        0);
    const nlohmann::json stats = json(folder / "s.json");
    CHECK(stats["machine"]["name"] == stats["configuration"]["machine"]["name"]);
    return std::pair(stats["machine"]["name"].get<std::string>(), stats["clocks"].get<std::uint64_t>());
  };
  const auto set = clocks("--set alu.bits=4 --set memory.reads=2");
  CHECK(set == clocks("--machine pixel-planes-4+alu.bits=4+memory.reads=2"));
  CHECK(set.first == "pixel-planes-4+alu.bits=4+memory.reads=2");
  CHECK(set.second < clocks("").second);
  // The last value counts, and another spelling of the number gives the same machine.
  CHECK(set == clocks("--set alu.bits=2 --set alu.bits=04 --set memory.reads=2"));
  CHECK(clocks("--set alu.bits=2").first != clocks("--set alu.bits=4").first);
  CHECK(clocks("--machine pixel-square --set divider.kind=host").first == "pixel-square+divider.kind=host");
}

TEST_CASE("a machine file that changes a built-in machine is named after its changes") {
  const Folder folder;
  std::string text = content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml");
  write(folder / "same.toml", text);
  const std::string figure = "[alu.bits]\nvalue = 1";
  REQUIRE(text.find(figure) != std::string::npos);
  text.replace(text.find(figure), figure.size(), "[alu.bits]\nvalue = 4");
  write(folder / "wide.toml", text);
  const auto first_line = [&](const std::string& words) {
    const Outcome outcome = run_words({"manual", "machines", folder / words}, folder.path());
    return outcome.out.substr(0, outcome.out.find('\n'));
  };
  CHECK(first_line("same.toml") == "pixel-planes-4");
  CHECK(first_line("wide.toml") == "pixel-planes-4+alu.bits=4");
  CHECK(first_line("wide.toml+memory.reads=2") == "pixel-planes-4+alu.bits=4+memory.reads=2");
  CHECK(first_line("wide.toml+alu.bits=1") == "pixel-planes-4");
}

TEST_CASE("reports a wrong --set in one line with the nearest parameter or key") {
  const std::string render = "render " + model("old_example002") + " --size 16x16 ";
  check_misuse(render + "--set alu.bit=4",
               "'alu.bit' is neither a machine parameter nor a scene key; did you mean alu.bits?");
  check_misuse(render + "--set ambience.intensity=1", "did you mean ambient.intensity?");
  check_misuse(render + "--set ambient.intensty=1", "ambient.intensity");
  check_misuse(render + "--set alu.bits=99", "alu.bits is 99; it must be");
  check_misuse(render + "--set alu.bits=wide", "alu.bits is 'wide'; write a whole number of bits");
  check_misuse(render + "--set alu.bits", "'alu.bits' is not of the form KEY=VALUE");
  check_misuse(render + "--set divider.kind=host",
               "pixel-planes-4 has no such parameter, but machines of the kind pixel-square");
  check_misuse("run x.csgt --set ambient.intensity=1", "'ambient.intensity=1' is a key of a scene");
  check_misuse("manual machines --set ambient.intensity=1", "'ambient.intensity=1' is a key of a scene");
}

TEST_CASE("--set applies to each machine with the parameter and fails if there is none") {
  const Folder folder;
  const std::string compare = "compare " + model("thesis_fig_2_3") +
                              " --size 16x16 --sides '' --fragments '' --no-plots -o " + (folder / "out") +
                              " --machines ";
  const Outcome outcome = require_success(run(compare + "pixel-planes-4,multi-processor --set alu.bits=4"));
  CHECK(outcome.out.find("pixel-planes-4+alu.bits=4 ") != std::string::npos);
  CHECK(outcome.out.find("multi-processor ") != std::string::npos);
  CHECK(content(folder / "out/compare.csv").find("pixel-planes-4+alu.bits=4") != std::string::npos);
  check_misuse(compare + "scan-line,multi-processor --set alu.bits=4",
               "none of scan-line, multi-processor has that parameter");
  check_misuse(compare + "pixel-planes-4 --set alu.bits=99", "alu.bits is 99");
  const Outcome listed = require_success(run("manual machines --set alu.bits=4"));
  CHECK(listed.out.find("pixel-planes-4+alu.bits=4\n") != std::string::npos);
  CHECK(listed.out.find("\nscan-line\n") != std::string::npos);
}

TEST_CASE("sweep and diff and debug and wave accept --set and print the machine's name") {
  const Folder folder;
  const std::string sweep = "sweep " + model("thesis_fig_2_3") +
                            " --size 16x16 --strategy stack --no-plots --set alu.bits=4 -o " + (folder / "out");
  require_success(run(sweep));
  CHECK(content(folder / "out/sweep.csv").find("pixel-planes-4+alu.bits=4") != std::string::npos);
  const std::string trace = std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt";
  const Outcome diff = run("diff " + trace + " --set-b alu.bits=4 --no-stories");
  CHECK(diff.out.find("B  " + trace + ": pixel-planes-4+alu.bits=4, ") != std::string::npos);
  CHECK(run("diff " + trace + " --set-b ambient.intensity=1").code == 2);
  require_success(run("debug " + trace + " --set alu.bits=4"));
  require_success(run("explain " + trace + " --pixel 5,5 --set alu.bits=4"));
  require_success(run("wave " + trace + " --pixel 5,5 --window 0:20 --set alu.bits=4 -o " + (folder / "w.vcd")));
  CHECK(content(folder / "w.gtkw").find("pixel-planes-4+alu.bits=4") != std::string::npos);
}
