/// Stats files, shards and tables written or modified by third parties: their contents are untrusted data.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

using Words = std::vector<std::string>;
using Json = nlohmann::ordered_json;

const std::string cube = "cube(size = [8, 6, 4], center = true);\n";

Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Checks for exit code 1 and one line that begins with the file's name and contains the text.
void refused(const Outcome& outcome, const std::string& file, const std::string& text) {
  CAPTURE(outcome.out);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 1);
  CHECK(is_one_line(outcome.err));
  CHECK(outcome.err.starts_with(file + ":"));
  CHECK(outcome.err.find(text) != std::string::npos);
  CHECK(outcome.err.find("report it") == std::string::npos);
}

/// The content of every file in the folder and its subfolders, by name.
std::map<std::string, std::string> files_in(const Folder& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    if (entry.is_regular_file()) files[entry.path().native()] = content(entry.path());
  return files;
}

/// A modified stats file of a render.
class Stats {
 public:
  Stats() {
    write(folder / "m.csg", cube);
    REQUIRE(run_words({"render", "m.csg", "--size", "16x16", "--stats", "s.json"}, folder.path()).code == 0);
  }

  void change(const std::function<void(Json&)>& change) const {
    Json stats = Json::parse(content(folder / "s.json"));
    change(stats);
    write(folder / "t.json", stats.dump());
  }

  void set_option(const std::string& name, const Json& value) const {
    change([&](Json& stats) { stats["configuration"]["options"][name] = value; });
  }

  [[nodiscard]] Outcome rerun(const Words& more = {}) const {
    return run_words(Words{"rerun", "t.json"} + more, folder.path());
  }

  /// Checks that rerun rejects the file and writes nothing.
  void check_rejected(const std::string& text, const Words& more = {}) const {
    const std::map<std::string, std::string> before = files_in(folder);
    refused(rerun(more), "t.json", text);
    CHECK(files_in(folder) == before);
  }

  Folder folder;
};

const Words sweep{"sweep", "m.csg", "--size", "16x16", "--strategy", "stack,list"};
const Words compare{"compare", "m.csg",       "--size", "16x16",      "--sides",
                    "",        "--fragments", "",       "--machines", "pixel-planes-4,scan-line"};

/// The shards of a study in out/shards, whose texts can be modified.
class Shards {
 public:
  explicit Shards(const Words& study) {
    write(folder / "m.csg", cube);
    for (const std::string shard : {"1/2", "2/2"})
      REQUIRE(run_words(study + Words{"--shard", shard, "-o", "out"}, folder.path()).code == 0);
    for (const auto& entry : fs::directory_iterator(folder / "out/shards")) files.push_back(entry.path());
    std::ranges::sort(files);
    REQUIRE(files.size() == 2);
    for (const std::string& file : files) texts.push_back(content(file));
  }

  /// Replaces a text in each file, whose first two lines have the command; returns the number of replacements.
  std::size_t replace(const std::string& from, const std::string& to) const {
    std::size_t places = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
      std::string text = texts[i];
      for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size(), ++places)
        text.replace(at, from.size(), to);
      write(files[i], text);
    }
    return places;
  }

  /// Checks that gather rejects the shards and writes nothing.
  void check_rejected(const std::string& text) const {
    const std::map<std::string, std::string> before = files_in(folder);
    for (const Words& more : {Words{"--missing"}, Words{"--no-plots"}})
      refused(run_words(Words{"gather", "out"} + more, folder.path()),
              "out/shards/" + fs::path(files[0]).filename().native(), text);
    CHECK(files_in(folder) == before);
  }

  Folder folder;
  Words files;
  Words texts;
};

}  // namespace

TEST_CASE("a stats file cannot name a settings file or an output") {
  const Stats stats;
  write(stats.folder / "evil.toml",
        "[render]\noutput = 'home.png'\nstats = 'any_name'\nreport = 'x.html'\n[run]\ncheckpoint = 'bashrc'\n");
  for (const std::string name : {"home.png", "any_name", "x.html", "bashrc"}) write(stats.folder / name, "precious");
  stats.set_option("config", "evil.toml");
  stats.check_rejected("'config' is not an option that csgsim render records in a stats file");
  stats.change([](Json& json) {
    for (const char* const option : {"output", "depth", "owner", "stats", "report"})
      json["configuration"]["options"][option] = "home.png";
  });
  const std::map<std::string, std::string> before = files_in(stats.folder);
  const Outcome again = stats.rerun();
  CAPTURE(again.err);
  CHECK(again.code == 0);
  CHECK(files_in(stats.folder) == before);
}

TEST_CASE("rerun reports equality only of results that it compared") {
  const Stats stats;
  for (const std::string name : {"help", "dump-config", "version", "no-such-option"}) {
    CAPTURE(name);
    stats.set_option(name, true);
    stats.check_rejected(fmt::format("'{}' is not an option that csgsim render records in a stats file", name),
                         {"-o", "a.png"});
  }
  stats.set_option("frames", 2);
  stats.check_rejected("--frames: a sequence of frames cannot be rerun", {"-o", "a.png"});
  stats.change([](Json& json) { json["clocks"] = 1; });
  refused(stats.rerun(), "t.json", "the run differs: /clocks was 1, is");
}

TEST_CASE("a value in a stats file sets no other option whatever its bytes") {
  const Stats stats;
  for (const std::string name : {"model", "machine", "camera", "size"}) {
    CAPTURE(name);
    stats.set_option(name, std::string("pixel-planes-4\0--output=home.png", 32));
    stats.check_rejected("where a string should be");
    stats.set_option(name, Json{{"hex", "002d"}});
    stats.check_rejected("where a string should be");
  }
  stats.set_option("set", Json::array({"", "--output=home.png"}));
  stats.check_rejected("--set");
  stats.set_option("set", Json::array({std::string("\0", 1)}));
  stats.check_rejected("where a string should be");
  stats.set_option("machine", "--output=home.png");
  CHECK(stats.rerun().err.find("--output=home.png") != std::string::npos);
  CHECK(!fs::exists(stats.folder / "home.png"));
  stats.set_option("z-bits", "20 --output=home.png");
  stats.check_rejected("20 --output=home.png");
  stats.set_option("view-all", "yes");
  stats.check_rejected("has \"yes\" where true or false should be");
  stats.set_option("set", 5);
  stats.check_rejected("has 5 where a list");
  stats.set_option("set", Json(std::vector<std::string>(10001, "a")));
  stats.check_rejected("where a list of at most 10000 texts should be");
}

TEST_CASE("rerun rejects any malformed stats file in one line with its place") {
  const Stats stats;
  write(stats.folder / "t.json", "{\"configuration\": {},\n \"clocks\": 1e999}");
  stats.check_rejected("t.json:2:");
  write(stats.folder / "t.json", "{\"configuration\": {\"a\": \"\xff\"}}");
  stats.check_rejected("t.json:1:");
  for (const Json& value : {Json(), Json(5), Json("text"), Json::array(), Json::array({1, 2}), Json::object()}) {
    for (const std::string place : {"", "/options", "/options/model", "/options/threads", "/inputs", "/inputs/0",
                                    "/inputs/0/file", "/inputs/0/hash", "/machine", "/machine/hash", "/model",
                                    "/model/hash", "/picture", "/picture/hash", "/command", "/command/1", "/version"}) {
      CAPTURE(place);
      CAPTURE(value.dump());
      stats.change([&](Json& json) { json["configuration"][Json::json_pointer(place)] = value; });
      const Outcome outcome = stats.rerun();
      CAPTURE(outcome.err);
      // An empty list of inputs cannot reveal a changed file; the compared results are equal.
      const bool is_fine = (place == "/inputs" && value.is_array() && value.empty()) ||
                           (place == "/options/threads" && (value.is_null() || value == 5));
      CHECK(outcome.code == (is_fine ? 0 : 1));
      if (!is_fine) CHECK(is_one_line(outcome.err));
      CHECK(outcome.err.find("report it") == std::string::npos);
    }
  }
}

TEST_CASE("rerun -o - writes to standard output and not to a file of that name") {
  const Stats stats;
  stats.change([](Json&) {});
  const Outcome outcome = stats.rerun({"-o", "-"});
  CHECK(outcome.code == 0);
  CHECK(outcome.out.starts_with("\x89PNG"));
  CHECK(!fs::exists(stats.folder / "-"));
}

TEST_CASE("gather rejects a shard whose command is not a study or has unknown options") {
  const Shards shards(sweep);
  write(shards.folder / "evil.toml", "[sweep]\noutput = 'else'\nreport = 'x.html'\n");
  write(shards.folder / "x.html", "precious");
  for (const std::string words : {"--config,evil.toml", "-o,else", "--output=else", "--report,x.html",
                                  "--report=x.html", "--threads,7", "--quiet", "--no-plots", "--shard,1/7", "--help",
                                  "--dump-config", "--no-such-option", "++,--describe=x.html"}) {
    CAPTURE(words);
    REQUIRE(shards.replace(",--size,", "," + words + ",--size,") == 4);
    shards.check_rejected("the command is not one of a shard");
  }
  for (const std::string words : {"--describe=x.html", "--version", "--help", "render", "rerun", ""}) {
    CAPTURE(words);
    REQUIRE(shards.replace(",sweep,m.csg,", "," + words + ",m.csg,") == 4);
    shards.check_rejected("the command is not one of a shard");
  }
  REQUIRE(shards.replace(",sweep,m.csg,", std::string(",sweep,m.csg\0,", 14)) == 4);
  shards.check_rejected("the command is not one of a shard");
  REQUIRE(shards.replace(",--size,", ",--size,") == 4);
  CHECK(run_words({"gather", "out", "--no-plots"}, shards.folder.path()).code == 0);
}

TEST_CASE("the command stored in a shard omits a flag that was switched off") {
  const Folder folder;
  write(folder / "m.csg", cube);
  write(folder / "s.toml", "view-all = true\n");
  const Words study = sweep + Words{"--config", "s.toml", "--view-all=false", "-o", "out", "--shard"};
  for (const std::string shard : {"1/2", "2/2"}) REQUIRE(run_words(study + Words{shard}, folder.path()).code == 0);
  for (const auto& entry : fs::directory_iterator(folder / "out/shards"))
    CHECK(content(entry.path()).find("view-all") == std::string::npos);
  CHECK(run_words({"gather", "out", "--no-plots"}, folder.path()).code == 0);
}

TEST_CASE("rejects a shard with a byte that is invalid in text and names the file") {
  const std::map<std::string, std::string> of_compare{{",scan-line,", ",scan\x9fline,"}, {"cube@", "cu\xc0@"}};
  const std::map<std::string, std::string> of_sweep{{",auto,", ",au\x9fo,"}, {"Z1=", "Z\x1b="}};
  for (const auto& [study, changes] :
       std::map<Words, std::map<std::string, std::string>>{{compare, of_compare}, {sweep, of_sweep}}) {
    const Shards shards(study);
    for (const auto& change : changes) {
      CAPTURE(change.first);
      REQUIRE(shards.replace(change.first, change.second) > 0);
      const Outcome outcome = run_words({"gather", "out", "--no-plots"}, shards.folder.path());
      CAPTURE(outcome.err);
      CHECK(outcome.code == 1);
      CHECK(is_one_line(outcome.err));
      CHECK(outcome.err.starts_with("out/shards/" + study.front() + "-"));
      CHECK(outcome.err.find("contains unprintable characters") != std::string::npos);
      CHECK(!fs::exists(shards.folder / ("out/" + study.front() + ".json")));
    }
  }
}

TEST_CASE("rejects a shard with a non-finite number or an impossible number of points") {
  const Shards shards(compare);
  for (const std::string number : {"nan", "inf", "-inf", "1e999"}) {
    REQUIRE(shards.replace(",16,16,0,,", ",16,16," + number + ",,") == 2);
    const Outcome outcome = run_words({"gather", "out", "--no-plots"}, shards.folder.path());
    CAPTURE(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(outcome.err.starts_with("out/shards/compare-"));
    CHECK(outcome.err.find("'" + number + "' is not a finite number") != std::string::npos);
  }
  for (const std::string points : {"0", "1000001", "18446744073709551615"}) {
    REQUIRE(shards.replace(",2,2,", ",2," + points + ",") >= 2);
    shards.check_rejected(":1:1: the number of points must be from 1 to 1000000, not " + points);
  }
}

TEST_CASE("gather accepts any name of an ideal parameter and any number of memory bits") {
  const Shards ideal({"compare", "m.csg", "--size", "16x16", "--machines", "pixel-planes-4", "--ideal"});
  REQUIRE(ideal.replace(",16,16,0,,", ",16,16,0,x,") == 1);
  CHECK(run_words({"gather", "out"}, ideal.folder.path()).code == 0);
  const Shards bits(sweep);
  REQUIRE(bits.replace(",pixel-planes-4,72,", ",pixel-planes-4,4294967295,") == 2);
  const Outcome outcome =
      run_program("timeout", {"20", std::string(CSGSIM_BINARY_DIR) + "/csgsim", "gather", "out"}, bits.folder.path());
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
}

TEST_CASE("differing pictures in rows read from a file are not reported as a bug of csgsim") {
  for (const Words& study : {sweep, compare}) {
    const Shards shards(study);
    const std::string& text = shards.texts[0];
    const std::size_t end = text.rfind(",\n", text.size());
    REQUIRE(end != std::string::npos);
    std::string changed = text;
    changed[end - 1] = changed[end - 1] == '0' ? '1' : '0';
    write(shards.files[0], changed);
    const Outcome gathered = run_words({"gather", "out", "--no-plots"}, shards.folder.path());
    CAPTURE(gathered.err);
    CHECK(gathered.code == 1);
    CHECK(is_one_line(gathered.err));
    CHECK(gathered.err.find("may have been changed: measure everything again in another folder (-o)") !=
          std::string::npos);
    CHECK(gathered.err.find("error in csgsim") == std::string::npos);
    // The same study, resumed from that table.
    const Outcome resumed = run_words(study + Words{"-o", "out", "--no-plots"}, shards.folder.path());
    CHECK(resumed.code == 1);
    CHECK(resumed.err == gathered.err);
  }
}

TEST_CASE("a waveform that exceeds the disk space is reported and leaves no file") {
  const Folder folder;
  const std::string command = fmt::format(
      "ulimit -f 10; trap '' XFSZ; exec {}/csgsim wave {} --size 16x16 --pixel 3,3 --window 0:4000 -o w.vcd",
      CSGSIM_BINARY_DIR, model("thesis_fig_2_3"));
  for (const std::string more : {"", " --whole"}) {
    const Outcome outcome = run_program("/bin/sh", {"-c", command + more}, folder.path());
    CAPTURE(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(is_one_line(outcome.err));
    CHECK(outcome.err.starts_with("w.vcd: cannot be written: File too large"));
    CHECK(folder.files() == 0);
  }
}
