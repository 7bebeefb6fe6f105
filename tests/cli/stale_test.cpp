#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string cube = "cube(size = [8, 6, 4], center = true);\n";
const std::string multmatrix =
    "multmatrix([[1,0,0,2],[0,1,0,2],[0,0,1,2],[0,0,0,1]]) { cube(size = [5,5,5], center = false); }\n";

std::string machine_text() { return content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml"); }

/// A machine file of pixel-planes-4 with another ALU width.
std::string with_alu_bits(unsigned bits) {
  std::string text = machine_text();
  const std::size_t value = text.find("value = ", text.find("[alu.bits]"));
  REQUIRE(value != std::string::npos);
  text.replace(value, text.find('\n', value) - value, "value = " + std::to_string(bits));
  return text;
}

std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words{command, "m.csg", "--size", "24x24", "-o", "out", "--no-plots"};
  if (command == "compare")
    words.insert(words.end(), {"--machines", "mine.toml", "--sides", "", "--fragments", ""});
  else
    words.insert(words.end(), {command == "sweep" ? "--machines" : "--machine", "mine.toml"});
  if (command == "sweep") words.insert(words.end(), {"--strategy", "stack,list"});
  if (command == "advise")
    words.insert(words.end(), {"--strategy", "stack,list", "--z-bits", "16", "--fraction-bits", "6"});
  if (command == "accuracy") words.insert(words.end(), {"--views", "1"});
  return words;
}

nlohmann::json points(const Folder& folder, const std::string& command) {
  return json(folder / ("out/" + command + ".json"))["points"];
}

}  // namespace

TEST_CASE("a study reports and remeasures points whose machine or model has changed") {
  for (const std::string command : {"sweep", "compare", "accuracy", "advise"}) {
    CAPTURE(command);
    const Folder folder;
    write(folder / "m.csg", cube);
    write(folder / "mine.toml", with_alu_bits(1));
    const std::vector<std::string> words = words_of(command);
    require_success(run_words(words, folder.path()));
    const nlohmann::json before = points(folder, command);

    // A comment does not affect the measurements.
    write(folder / "mine.toml", "# looked through\n" + with_alu_bits(1));
    CHECK(run_words(words, folder.path()).err == "");
    CHECK(points(folder, command) == before);

    write(folder / "mine.toml", with_alu_bits(8));
    const Outcome other_machine = require_success(run_words(words, folder.path()));
    CHECK(is_one_line(other_machine.err));
    CHECK(other_machine.err.find("the machine has changed") != std::string::npos);
    const nlohmann::json wider = points(folder, command);
    REQUIRE(wider.size() == before.size());
    for (std::size_t i = 0; i < wider.size(); ++i) CHECK(wider[i]["clocks"] < before[i]["clocks"]);

    write(folder / "m.csg", cube + multmatrix);
    const Outcome other_model = run_words(words, folder.path());
    CHECK(other_model.err.find("the model has changed") != std::string::npos);
    const nlohmann::json larger = points(folder, command);
    REQUIRE(larger.size() == before.size());
    for (std::size_t i = 0; i < larger.size(); ++i) CHECK(larger[i]["clocks"] > wider[i]["clocks"]);
    CHECK(run_words(words, folder.path()).err == "");
    CHECK(points(folder, command) == larger);
  }
}

TEST_CASE("a study remeasures points that another build of csgsim measured") {
  const Folder folder;
  write(folder / "m.csg", cube);
  write(folder / "mine.toml", machine_text());
  const std::vector<std::string> words = words_of("sweep");
  require_success(run_words(words, folder.path()));
  const std::string table = content(folder / "out/sweep.csv");
  const std::string csgsim = points(folder, "sweep")[0]["csgsim"];
  CHECK(csgsim.size() > std::string("0.1.0 ").size());
  std::string older = table;
  older.replace(older.find(csgsim), csgsim.size(), "0.0.9 0123456789abcdef");
  write(folder / "out/sweep.csv", older);
  const Outcome outcome = run_words(words, folder.path());
  CHECK(outcome.err.find("csgsim has changed") != std::string::npos);
  CHECK(content(folder / "out/sweep.csv") == table);
}

TEST_CASE("a study rejects a folder measured with other options") {
  const Folder folder;
  write(folder / "m.csg", cube);
  write(folder / "mine.toml", machine_text());
  for (const std::string command : {"compare", "accuracy"}) {
    const std::vector<std::string> words = words_of(command);
    require_success(run_words(words, folder.path()));
    const std::string table = content(folder / ("out/" + command + ".csv"));
    for (const std::vector<std::string>& option :
         std::vector<std::vector<std::string>>{{"--z-bits", "16"},
                                               {"--fraction-bits", "8"},
                                               {"--edge-on", "0.125"},
                                               {"--strategy", "list"},
                                               {"--colouring", "field"},
                                               {"--colour-bits", "12"},
                                               {"--pruning", "no-hidden"},
                                               {"--view-all"},
                                               {"--projection", "perspective"},
                                               {"--camera", "20,-30,25,0,0,0"}}) {
      CAPTURE(option.front());
      std::vector<std::string> changed = words;
      changed.insert(changed.end(), option.begin(), option.end());
      fails(run_words(changed, folder.path()), 1, {"holds another study"});
    }
    CHECK(content(folder / ("out/" + command + ".csv")) == table);
  }
}

TEST_CASE("accuracy measures more clocks with --pruning none than with the default") {
  const Folder folder;
  write(folder / "m.csg", "difference() { sphere(r = 6, $fn = 24); " + multmatrix + multmatrix + " }");
  write(folder / "mine.toml", machine_text());
  std::vector<std::string> words = words_of("accuracy");
  require_success(run_words(words, folder.path()));
  const nlohmann::json usual = points(folder, "accuracy");
  words.insert(words.end(), {"--pruning", "none"});
  words[5] = "unpruned";
  require_success(run_words(words, folder.path()));
  const nlohmann::json unpruned = json(folder / "unpruned/accuracy.json")["points"];
  REQUIRE(unpruned.size() == usual.size());
  CHECK(unpruned[0]["clocks"] > usual[0]["clocks"]);
}

TEST_CASE("a study names the process that locks its folder and runs once it is unlocked") {
  const Folder folder;
  write(folder / "m.csg", cube);
  write(folder / "mine.toml", machine_text());
  fs::create_directory(folder / "out");
  for (const std::string command : {"sweep", "compare", "accuracy", "advise"}) {
    const int lock = ::open((folder / "out/.csgsim-lock").c_str(), O_RDWR | O_CREAT, 0600);
    REQUIRE(::flock(lock, LOCK_EX) == 0);
    REQUIRE(::write(lock, "process 12, sweep", 17) == 17);
    fails(run_words(words_of(command), folder.path()), 1, {"another csgsim is writing there (process 12, sweep)"});
    CHECK_FALSE(fs::exists(folder / ("out/" + command + ".csv")));
    ::close(lock);
    require_success(run_words(words_of(command), folder.path()));
    CHECK_FALSE(fs::exists(folder / "out/.csgsim-lock"));
  }
}

TEST_CASE("processes that start at once in one folder write no row twice") {
  const Folder folder;
  write(folder / "m.csg", content(model("carburettor")));
  const std::vector<std::string> words{"sweep",        "m.csg",     "--size",    "100x100", "--strategy",
                                       "bits",         "--threads", "1",         "-o",      "out",
                                       "--stack-bits", "3..8",      "--no-plots"};
  std::vector<pid_t> children;
  for (int process = 0; process < 4; ++process) {
    children.push_back(::fork());
    REQUIRE(children.back() >= 0);
    if (children.back() == 0) std::_Exit(run_words(words, folder.path()).code);
  }
  int done = 0;
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    const int code = WEXITSTATUS(status);
    CHECK((code == 0 || code == 1));
    done += code == 0 ? 1 : 0;
  }
  CHECK(done >= 1);
  const std::string table = content(folder / "out/sweep.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 6);
  require_success(run_words(words, folder.path()));
  CHECK(content(folder / "out/sweep.csv") == table);
}
