#include <regex>

#include "places.h"
#include "sim/session/options/option_table.h"
#include "sim/studies/rows.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

/// The commands listed by help, each after two blanks.
std::vector<std::string> commands() {
  std::vector<std::string> names;
  std::istringstream lines(run("--help").out);
  for (std::string line; std::getline(lines, line);) {
    const bool is_command = line.starts_with("  ") && line.size() > 2 && line[2] != ' ';
    if (is_command) names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  for (const csgsim::studies::StudyRow* const row : csgsim::studies::all())
    CHECK(std::ranges::count(names, row->name) == 1);
  return names;
}

/// An option of a settings file as --dump-config writes it: `key = value`, commented out if it is not set.
struct Key {
  std::string name;
  std::string value;
  bool is_said = false;
  std::string meaning;  ///< text of the comment above
};

std::vector<Key> keys_of(const std::string& settings) {
  std::vector<Key> keys;
  std::istringstream lines(settings);
  std::string before;
  for (std::string line; std::getline(lines, line); before = line) {
    const bool is_said = !line.starts_with("# ");
    const std::string text = is_said ? line : line.substr(2);
    const std::size_t equals = text.find(" = ");
    if (equals == std::string::npos || text.find(' ') != equals) continue;
    keys.push_back({text.substr(0, equals), text.substr(equals + 3), is_said, before});
  }
  return keys;
}

std::vector<Key> keys_of_command(const std::string& command) {
  const Outcome outcome = run(command + " --dump-config");
  CAPTURE(command);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  return keys_of(outcome.out);
}

/// Sample values that differ from the defaults, for options that do not take any text or number. An option with a fixed
/// set of words needs a line here.
const std::map<std::string, std::string> samples{{"projection", "\"perspective\""},
                                                 {"camera", "\"30,-40,20,0,0,0\""},
                                                 {"machine", "\"scan-line\""},
                                                 {"name", "\"scan-line\""},
                                                 {"machine-a", "\"scan-line\""},
                                                 {"machine-b", "\"scan-line\""},
                                                 {"machines", "\"scan-line\""},
                                                 {"curves", "\"facets\""},
                                                 {"form", "\"drampower\""},
                                                 {"knobs", "\"curves,size\""},
                                                 {"vary", "[\"alu.bits=1,2\"]"},
                                                 {"axes", "\"time,memory\""},
                                                 {"process", "\"cmos-45nm\""},
                                                 {"strategy", "\"list\""},
                                                 {"colour-scheme", "\"Metallic\""},
                                                 {"colouring", "\"field\""},
                                                 {"level", "\"reference\""},
                                                 {"evaluator", "\"stepped\""},
                                                 {"level-a", "\"reference\""},
                                                 {"level-b", "\"reference\""},
                                                 {"pruning", "\"none\""},
                                                 {"strategy-a", "\"list\""},
                                                 {"strategy-b", "\"list\""},
                                                 {"pruning-a", "\"none\""},
                                                 {"pruning-b", "\"none\""},
                                                 {"shard", "\"2/3\""},
                                                 {"progress", "\"none\""},
                                                 {"report", "\"page.html\""},
                                                 {"depth", "\"z.exr\""},
                                                 {"owner", "\"o.png\""},
                                                 {"surface", "\"opaque\""},
                                                 {"openscad-time", "60"},
                                                 {"define", "[\"n=3\"]"},
                                                 {"format", "\"stl\""},
                                                 {"tolerance", "\"0.5px\""},
                                                 {"tolerances", "\"0.5,1\""},
                                                 {"subdivisions", "\"4\""},
                                                 {"topic", "\"machines\""},
                                                 {"sides", "\"64\""},
                                                 {"fragments", "\"12\""},
                                                 {"stack-bits", "5"},
                                                 {"colour-bits", "15"},
                                                 {"z-bits", "16"},
                                                 {"fraction-bits", "7"},
                                                 {"alu-bits", "2"},
                                                 {"memory-bits", "96"},
                                                 {"methods", "\"standard\""},
                                                 {"coherences", "\"one-list\""},
                                                 {"shapes", "\"written\""},
                                                 {"reduced", "\"cells\""},
                                                 {"directories", "\"excell\""},
                                                 {"bucket-sizes", "\"4\""},
                                                 {"cast", "\"primary\""},
                                                 {"facet-test", "\"projected\""},
                                                 {"item-buffer", "\"without\""},
                                                 {"mailboxes", "\"without\""},
                                                 {"reflections", "2"},
                                                 {"flatness", "\"sides\""},
                                                 {"repairs", "\"quadtree\""},
                                                 {"processors", "\"mc68000\""},
                                                 {"with", "\"mc68000:weave\""},
                                                 {"parts", "\"speed\""}};

/// Options that exclude others.
const std::set<std::string> alone{"cameras", "point", "tolerances", "with"};

std::string sample(const std::string& command, const Key& key) {
  const auto found = samples.find(key.name);
  const bool is_text = key.value.starts_with('"');
  if (command == "levels" && key.name == "levels") return "\"cycle\"";
  if (command == "display" && key.name == "methods") return "\"scan-line\"";
  if (found != samples.end()) {
    const bool needs_quotes = is_text && !found->second.starts_with('"');
    return needs_quotes ? "\"" + found->second + "\"" : found->second;
  }
  if (is_text) return "\"word\"";
  if (key.value.starts_with('[')) return "[\"one\", \"two\"]";
  if (key.value == "false") return "true";
  return key.value.find('.') == std::string::npos ? "7" : "0.75";
}

/// The lines of a settings file that set these samples for the command.
std::string settings(const std::string& command, const std::vector<Key>& keys) {
  std::string text = "[" + command + "]\n";
  for (const Key& key : keys) text += fmt::format("{} = {}\n", key.name, sample(command, key));
  return text;
}

/// Checks that the command receives the settings.
void check_reached(const std::string& command, const std::vector<Key>& keys) {
  const Folder folder;
  write(folder / "s.toml", settings(command, keys));
  const Outcome outcome = run_words({command, "--config", "s.toml", "--dump-config"}, folder.path());
  CAPTURE(command);
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  const std::vector<Key> reached = keys_of(outcome.out);
  for (const Key& key : keys) {
    CAPTURE(key.name);
    const auto found = std::ranges::find(reached, key.name, &Key::name);
    REQUIRE(found != reached.end());
    CHECK(found->is_said);
    CHECK(found->value == sample(command, key));
  }
}

void refused(const std::string& command, const std::string& text, const std::string& message) {
  const Folder folder;
  write(folder / "s.toml", text);
  fails(run_words({command, model("old_example002"), "--config", "s.toml"}, folder.path()), 1, {message});
}

}  // namespace

TEST_CASE("a settings file can set every option of every command") {
  std::size_t options = 0;
  for (const std::string& command : commands()) {
    std::vector<Key> together = keys_of_command(command);
    CHECK(!together.empty());
    options += together.size();
    for (const std::string& name : alone) {
      const auto found = std::ranges::find(together, name, &Key::name);
      if (found == together.end()) continue;
      check_reached(command, {*found});
      together.erase(found);
    }
    check_reached(command, together);
  }
  CHECK(options > 200);
}

TEST_CASE("a settings file accepts every long option that help shows") {
  for (const std::string& command : commands()) {
    const std::vector<Key> keys = keys_of_command(command);
    std::istringstream lines(run(command + " --help").out);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t begin = line.find("--");
      if (!line.starts_with("  -") || begin == std::string::npos) continue;
      const std::string name = line.substr(begin + 2, line.find_first_of(" ,=", begin) - begin - 2);
      if (name == "help" || name == "config" || name == "dump-config") continue;
      CAPTURE(command);
      CAPTURE(name);
      CHECK(std::ranges::find(keys, name, &Key::name) != keys.end());
    }
  }
}

TEST_CASE("every option that names a file is relative to the settings file's folder") {
  const std::regex of_file(R"(\.(png|exr|json|csg|csgt|toml|vcd|scad)\b|[Ff]older|[Ff]ile)");
  std::size_t files = 0;
  for (const std::string& command : commands()) {
    for (const Key& key : keys_of_command(command)) {
      const bool is_text = key.value.starts_with('"') || key.value.starts_with('[');
      if (!is_text || !std::regex_search(key.meaning, of_file)) continue;
      CAPTURE(command);
      CAPTURE(key.name);
      CHECK(csgsim::session::known_option(key.name).role != csgsim::session::FileRole::none);
      ++files;
    }
  }
  CHECK(files > 50);
}

TEST_CASE("the output of --dump-config is a settings file that changes nothing") {
  const Folder folder;
  const std::vector<std::string> words{"render", "m.csg", "--set", "alu.bits=4", "--view-all", "--tolerance", "0.5px"};
  const auto dumped = [&](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    more.emplace_back("--dump-config");
    return run_words(more, folder.path()).out;
  };
  const std::string first = dumped({});
  write(folder / "s.toml", first);
  CHECK(first.find("tolerance = \"0.5px\"") != std::string::npos);
  CHECK(run_words({"render", "--config", "s.toml", "--dump-config"}, folder.path()).out == first);
}

TEST_CASE("the command line overrides a settings file's table of the command and its top") {
  const Folder folder;
  write(folder / "s.toml",
        "z-bits = 16\nview-all = true\n[render]\nz-bits = 18\nset = ['alu.bits=2']\n[levels]\nsnap = true\n");
  const auto value = [&](std::vector<std::string> words, const std::string& name) {
    words.insert(words.end(), {"--config", "s.toml", "--dump-config"});
    const std::vector<Key> keys = keys_of(run_words(words, folder.path()).out);
    return std::ranges::find(keys, name, &Key::name)->value;
  };
  CHECK(value({"compile"}, "z-bits") == "16");
  CHECK(value({"render"}, "z-bits") == "18");
  CHECK(value({"render", "--z-bits", "12"}, "z-bits") == "12");
  CHECK(value({"render", "--z-bits=12"}, "z-bits") == "12");
  CHECK(value({"render"}, "set") == "[\"alu.bits=2\"]");
  CHECK(value({"render", "m.csg", "--set", "alu.bits=8"}, "set") == "[\"alu.bits=8\"]");
  CHECK(value({"render"}, "view-all") == "true");
  CHECK(value({"render", "--view-all=false"}, "view-all") == "false");
  CHECK(value({"render"}, "snap") == "false");
  CHECK(value({"levels"}, "snap") == "true");
}

TEST_CASE("an option on the command line replaces a setting that excludes it") {
  const Folder folder;
  write(folder / "s.toml", "point = '0,0,0'\n");
  const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt";
  require_success(run_words({"explain", program, "--pixel", "5,5", "--config", "s.toml"}, folder.path()));
  refused("explain", "point = '0,0,0'\npixel = '1,1'\n", "s.toml:2:1: pixel excludes another option");
}

TEST_CASE("reports an error in a settings file with its place") {
  refused("render", "z-bit = 16\n",
          "s.toml:1:1: 'z-bit' is not an option of any command; the nearest known is 'z-bits'");
  refused("render", "\n[render]\nstratgy = 'list'\n",
          "s.toml:3:1: 'stratgy' is not an option of render; the nearest known is 'strategy'");
  refused("render", "[sweep]\nturn = 3\n", "s.toml:2:1: 'turn' is not an option of sweep");
  refused("render", "[rendr]\nturn = 3\n",
          "s.toml:1:2: 'rendr' is not an option of any command; the nearest known is 'render'");
  refused("render", "z-bits = '16'\n", "s.toml:1:10: z-bits is a string; make it an integer");
  refused("render", "z-bits = -1\n", "s.toml:1:10: z-bits is -1; make it 0 or more");
  refused("render", "z-bits = 1.5\n", "s.toml:1:10: z-bits is a number with a point; make it an integer");
  refused("render", "near = nan\n", "s.toml:1:8: near is not finite");
  refused("render", "view-all = 1\n", "s.toml:1:12: view-all is an integer; make it true or false");
  refused("render", "output = ['a.png']\n", "s.toml:1:10: output is an array; make it a string");
  refused("render", "camera = [1, [2]]\n", "s.toml:1:14: camera is an array");
  refused("render", "set = [true]\n", "s.toml:1:8: set is a boolean; make it a string");
  refused("render", "output = \"a\\u0000\"\n", "s.toml:1:10: output contains a zero byte");
  refused("render", "strategy = 'stak'\n", "s.toml:1:1: --strategy: ");
  refused("render", "memory-bits = 5000\n", "s.toml:1:1: --memory-bits: ");
  refused("render", "size = '3'\n", "s.toml:1:1: --size: '3' is not of the form WxH");
  refused("render", "set = ['ambient.intensity=7']\n", "s.toml:1:1: --set ambient.intensity=7");
  refused("render", "render = 3\n", "s.toml:1:1: 'render' is an integer; make it a table, [render]");
  refused("render", "z-bits = \n", "s.toml:1:10: ");
  fails(run("render m.csg --config no.toml"), 1, {"no.toml: cannot be read"});
}

TEST_CASE("reports an error in a settings file even if the command line overrides it") {
  const Folder folder;
  write(folder / "s.toml", "strategy = 'stak'\n");
  fails(run_words({"render", "m.csg", "--strategy", "list", "--config", "s.toml"}, folder.path()), 1,
        {"s.toml:1:1: --strategy: "});
}

TEST_CASE("a settings file that names files of its folder draws like the command line") {
  const Folder folder;
  fs::create_directory(folder / "job");
  fs::copy(model("old_example002"), folder / "job/m.csg");
  fs::copy(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/scan-line.toml", folder / "job/mine.toml");
  write(folder / "job/look.toml", "[ambient]\nintensity = 0.6\n");
  write(folder / "job/run.toml",
        "model = 'm.csg'\nmachine = 'mine.toml'\nscene = 'look.toml'\noutput = 'p.png'\nstats = 's.json'\n"
        "size = '40x30'\ncamera = [65, -95, 60, 0, 0, -2.5]\npruning = 'no-hidden+no-sets'\nset = ['cells.words=6']\n");
  require_success(run_words({"render", "--config", "job/run.toml"}, folder.path()));
  require_success(run_words({"render", "job/m.csg", "--machine", "job/mine.toml", "--scene", "job/look.toml", "-o",
                             "q.png", "--stats", "q.json", "--size", "40x30", "--camera", "65,-95,60,0,0,-2.5",
                             "--pruning", "no-hidden+no-sets", "--set", "cells.words=6"},
                            folder.path()));
  CHECK(content(folder / "job/p.png") == content(folder / "q.png"));
  nlohmann::json by_file = json(folder / "job/s.json");
  nlohmann::json by_words = json(folder / "q.json");
  for (nlohmann::json* stats : {&by_file, &by_words}) {
    stats->erase("wall_seconds");
    (*stats)["configuration"].erase("command");
    for (const std::string name : {"output", "stats"}) (*stats)["configuration"]["options"].erase(name);
  }
  CHECK(by_file == by_words);
}

TEST_CASE("operands on the command line replace those of a settings file") {
  const Folder folder;
  write(folder / "s.toml", "program = 'no.csgt'\noutput = 'text'\n");
  const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt";
  require_success(run_words({"disasm", program, "--config", "s.toml"}, folder.path()));
  CHECK(run_words({"disasm", "--config", "s.toml"}, folder.path()).err.find("no.csgt") != std::string::npos);
}

TEST_CASE("a sweep's table is equal with options in a file or on the command line") {
  const Folder folder;
  write(folder / "s.toml", "size = '16x16'\n[sweep]\nstrategy = ['stack', 'list']\nno-plots = true\nno-draw = true\n");
  const std::vector<std::string> words{"sweep", model("thesis_fig_2_3"), "-o", "out"};
  std::vector<std::string> by_words = words;
  by_words.insert(by_words.end(), {"--size", "16x16", "--strategy", "stack,list", "--no-plots", "--no-draw"});
  std::vector<std::string> by_file = words;
  by_file.insert(by_file.end(), {"--config", "s.toml"});
  require_success(run_words(by_words, folder.path()));
  const std::string table = content(folder / "out/sweep.csv");
  require_success(run_words(by_file, folder.path()));
  CHECK(content(folder / "out/sweep.csv") == table);
}
