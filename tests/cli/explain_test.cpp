#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

/// The first box covers columns 1 to 4 and rows 1 to 4 of 8 x 6, the second, nearer one columns 3 to 6, rows 2 and 3.
const std::string two_boxes =
    "union(){multmatrix([[1,0,0,1],[0,1,0,2],[0,0,1,-5],[0,0,0,1]]){cube(size=[4,3,4],center=false);}\n"
    "multmatrix([[1,0,0,3],[0,1,0,0],[0,0,1,-4],[0,0,0,1]]){cube(size=[4,1,2],center=false);}}\n";
const std::string front = " --size 8x6 --camera 4,-15.08202,-3,4,0,-3 ";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct Subject {
  Subject() {
    write(folder / "m.csg", two_boxes);
    require_success(run("compile " + model + front + "-o " + program));
  }
  Folder folder;
  std::string model = folder / "m.csg";
  std::string program = folder / "p.csgt";
};

}  // namespace

TEST_CASE("explain names the owner and its line for a Program as for its model") {
  const Subject subject;
  const Outcome of_model = require_success(run("explain " + subject.model + front + "--pixel 4,2"));
  CHECK(of_model.out.starts_with("pixel 4,2 shows p1 cube@2:56, line 2 of "));
  CHECK(contains(of_model.out, "normal (0, -1, 0), distance 0"));
  CHECK(contains(of_model.out, "over p0 cube@1:64"));
  const Outcome of_program = require_success(run("explain " + subject.program + " --pixel 4,2"));
  CHECK(of_program.out.starts_with("pixel 4,2 shows p1 cube@2:56, line 2 of "));
  CHECK_FALSE(contains(of_program.out, "normal"));
  const Outcome nothing = run("explain " + subject.program + " --pixel 0,0");
  CHECK(nothing.out.starts_with("pixel 0,0 shows nothing\n"));
}

TEST_CASE("explain accepts a point of the model in place of its pixel") {
  const Subject subject;
  const Outcome outcome = require_success(run("explain " + subject.model + front + "--point 4.4,0,-2.6"));
  CHECK(outcome.out.starts_with(
      "point 4.4,0,-2.6 is 15.082 model units in front of the eye, along the view axis\npixel 4,2 shows p1 "));
}

TEST_CASE("explain says why a primitive is hidden that is named by index or name or line") {
  const Subject subject;
  for (const std::string name : {"0", "p0", "cube@1:64", "cube@1", "@1"}) {
    CAPTURE(name);
    const Outcome outcome = require_success(run("explain " + subject.program + " --pixel 4,2 --why-not " + name));
    CHECK(outcome.out.starts_with("why not p0 cube@1:64\n  merged, but p1 cube@2:56 was merged over it at i"));
  }
}

TEST_CASE("explain numbers instructions as disasm does") {
  const Subject subject;
  require_success(run("explain " + subject.program + " --pixel 4,2 --json " + (subject.folder / "s.json")));
  const nlohmann::json story = json(subject.folder / "s.json");
  const std::string text = run("disasm " + subject.program).out;
  unsigned decisions = 0;
  for (const nlohmann::json& event : story["events"]) {
    if (!event.contains("decision")) continue;
    const std::string number = "# i" + event["decision"]["instruction"].dump() + "\n";
    const std::size_t at = text.find(number);
    REQUIRE(at != std::string::npos);
    const std::string line = text.substr(text.rfind('\n', at) + 1, at - text.rfind('\n', at));
    CHECK(contains(line, event["decision"]["text"].get<std::string>()));
    ++decisions;
  }
  CHECK(decisions >= 4);
}

TEST_CASE("explain writes JSON to standard output with the reason why a primitive is hidden") {
  const Subject subject;
  const Outcome outcome =
      require_success(run("explain " + subject.model + front + "--pixel 2,2 --why-not 1 --json /dev/stdout"));
  const nlohmann::json story = nlohmann::json::parse(outcome.out);
  CHECK(story["owner"]["index"] == 0);
  CHECK(story["why_not"]["primitive"]["index"] == 1);
  CHECK(story["why_not"]["seen"] == false);
  CHECK(story["surfaces"][0]["fate"] == "seen");
}

TEST_CASE("explain rejects nonexistent pixels or points or primitives and states the range") {
  const Subject subject;
  const std::string program = "explain " + subject.program + " ";
  const std::string model = "explain " + subject.model + front;
  check_misuse(program + "--pixel 8,2", "there is no pixel 8,2 in a picture of 8 x 6");
  check_misuse(program + "--pixel 8", "x,y");
  check_misuse(program, "--pixel");
  check_misuse(program + "--point 1,2,3", "take --pixel");
  check_misuse(program + "--pixel 1,1 --strategy list", "--strategy");
  check_misuse(model + "--point 40,0,-3", "outside the picture");
  check_misuse(model + "--projection perspective --point 4,-20,-3", "behind the eye");
  check_misuse(model + "--pixel 1,1 --point 4,0,-3", "--pixel");
  check_misuse(program + "--pixel 1,1 --why-not cub@2:56", "the nearest is 'cube@2:56'");
  check_misuse(program + "--pixel 1,1 --why-not 2", "the Program has 2");
  check_misuse(program + "--pixel 1,1 --why-not @3", "there is no primitive '@3'");
  write(subject.folder / "l.csg", "union(){cube(size=[4,3,4],center=false);sphere($fn=5,r=1);}");
  check_misuse("explain " + (subject.folder / "l.csg") + " --size 8x6 --pixel 1,1 --why-not @1",
               "is ambiguous: p0 cube@1:9, p1");
  check_misuse(program + "--pixel 1,1 --json " + subject.program, "the same file");
}

TEST_CASE("an owner picture is written together with its legend or not at all") {
  const Subject subject;
  const Folder& folder = subject.folder;
  require_success(run("run " + subject.program + " --owner " + (folder / "o.png")));
  const nlohmann::json legend = json(folder / "o.json");
  // 4 x 4 pixels of the first box without 2 x 2 hidden by the second; 4 x 2 of the second.
  CHECK(legend["primitives"][0]["pixels"] == 12);
  CHECK(legend["primitives"][1]["pixels"] == 8);
  CHECK(legend["nothing"]["pixels"] == 48 - 20);
  CHECK(legend["primitives"][1]["name"] == "cube@2:56");
  CHECK(content(folder / "o.png").starts_with("\x89PNG"));
  check_misuse("run " + subject.program + " --owner " + (folder / "o.png") + " --stats " + (folder / "o.json"),
               "two outputs");
}
