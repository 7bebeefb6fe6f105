// A mistake ends with the same exit code in every command: 2 for a mistake in the arguments, 1 for one in a file
// (docs/command-line.md).

#include "hw/base/text.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

/// Commands that take a model, each with its required arguments.
std::vector<std::string> commands_of(const std::string& model, const Folder& folder) {
  const std::string out = " -o " + (folder / "out");
  return {"render " + model,
          "compile " + model + out,
          "debug " + model + " -x /dev/null",
          "diff " + model,
          "explain " + model + " --pixel 1,1",
          "wave " + model + " --pixel 1,1" + out + ".vcd",
          "subdivide " + model,
          "effects " + model,
          "levels " + model,
          "accuracy " + model + out,
          "advise " + model,
          "explore " + model + " --vary z-bits=12,16" + out};
}

}  // namespace

TEST_CASE("every command ends with exit code 2 for wrong arguments") {
  const Folder folder;
  for (const std::string& command : commands_of(model("sphere"), folder)) {
    for (const std::string mistake :
         {"--nope", "--machine pixel-plane", "--machine pixel-planes-4+alu.bit=4",
          "--machine pixel-planes-4+alu.bits=x", "--machine pixel-planes-4+alu.bits=999", "--set alu.bit=4",
          "--set alu.bits=x", "--set alu.bits=999", "--size 64", "--size 0x64", "--size 9999999x64", "--camera 1,2",
          "--camera 1,2,3,1,2,3", "--projection x", "--projection p --near=-3", "--limit 0", "--imgsize x",
          "one too many"}) {
      if (command.starts_with("explore") && mistake == "one too many") continue;  // it takes any number of models
      check_misuse(command + " " + mistake, "see csgsim ");
    }
  }
}

TEST_CASE("an unexpected argument and a missing value are named with the help to read") {
  const std::string render = "render " + model("sphere");
  check_misuse(render + " more",
               "unexpected argument 'more'; csgsim render takes only MODEL; see csgsim render --help");
  check_misuse(render + " one more",
               "unexpected argument 'one'; csgsim render takes only MODEL; see csgsim render --help");
  check_misuse(render + " --size", "--size: needs a value; see csgsim render --help");
}

TEST_CASE("every command ends with exit code 1 for a wrong or missing file") {
  const Folder folder;
  write(folder / "machine.toml", "x = 1\n");
  write(folder / "scene.toml", "[lamps]\n");
  write(folder / "key.toml", "stak = 1\n");
  write(folder / "range.toml", "limit = 0\n");
  write(folder / "machine_name.toml", "machine = \"pixel-plane\"\n");
  for (const std::string& command : commands_of(model("sphere"), folder)) {
    for (const std::string mistake :
         {"--machine none.toml", "--scene none.toml", "--config none.toml", "--machine machine.toml",
          "--scene scene.toml", "--config key.toml", "--config range.toml", "--config machine_name.toml"}) {
      const std::size_t file = mistake.find(' ') + 1;
      const Outcome outcome = run(command + " " + mistake.substr(0, file) + (folder / mistake.substr(file)));
      CAPTURE(command);
      CAPTURE(mistake);
      CHECK(outcome.code == 1);
      CHECK(is_one_line(outcome.err));
    }
  }
}

TEST_CASE("a wrong list of machines is a usage error but a list of numbers may be empty") {
  const Folder folder;
  const std::string out = " -o " + (folder / "out");
  for (const std::string study : {"compare ", "sweep ", "corpus "}) {
    check_misuse(study + model("sphere") + out + " --machines pixel-plane", "did you mean pixel-planes-4?");
    check_misuse(study + model("sphere") + out + " --machines ''", "empty element in list");
  }
  check_misuse("corpus " + model("sphere") + out + " --z-bits 31", "is not a whole number from 4 to 30");
  const std::string small = "compare " + model("sphere") + " --machines pixel-planes-4 --size 16x16 --no-plots";
  require_success(run(small + " --fragments none --sides none -o " + (folder / "none")));
  require_success(run(small + " --fragments '' --sides '' -o " + (folder / "empty")));
  CHECK(content(folder / "none/compare.csv") == content(folder / "empty/compare.csv"));
}

TEST_CASE("help shows -o FOLDER for each command that writes several files") {
  for (const std::string command : {"render", "compile", "run", "rerun", "disasm", "wave"})
    CHECK(run(command + " --help").out.find("-o, --output FILE") != std::string::npos);
  for (const std::string command : {"effects", "accuracy", "advise", "sweep", "corpus", "compare", "gather"})
    CHECK(run(command + " --help").out.find("-o, --output FOLDER") != std::string::npos);
}

TEST_CASE("the text output has percentages and grouped digits and the JSON output neither") {
  const Folder folder;
  const std::string of = " " + model("sphere") + " --size 64x64";
  const Outcome drawn = require_success(run("render" + of + " --check --verbose --stats " + (folder / "s.json")));
  const double busy = json(folder / "s.json")["account"]["controller_utilisation"];
  CHECK(busy < 1);
  CHECK(drawn.out.find(fmt::format("controller utilisation{:>20.2f} %", 100 * busy)) != std::string::npos);
  CHECK(drawn.out.find(csgsim::grouped(json(folder / "s.json")["clocks"]) + " clocks)") != std::string::npos);
  const std::string levels = run("levels" + of + " --levels functional").out;
  CHECK(levels.find(csgsim::grouped(json(folder / "s.json")["clocks"])) != std::string::npos);
}
