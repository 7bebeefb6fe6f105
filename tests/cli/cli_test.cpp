#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "csgsim-XXXXXX").string();
    REQUIRE(::mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator{}));
  }

 private:
  fs::path path_;
};

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// Runs csgsim with words that need no quoting.
Outcome csgsim(const std::string& words) {
  const Folder folder;
  const std::string command = std::string(CSGSIM_BINARY_DIR) + "/csgsim " + words + " >" + (folder / "out") + " 2>" +
                              (folder / "err") + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder / "out"), content(folder / "err")};
}

std::string model(const std::string& name) { return std::string(CSGSIM_SOURCE_DIR) + "/tests/models/" + name + ".csg"; }

nlohmann::json json(const std::string& path) { return nlohmann::json::parse(std::ifstream(path)); }

bool one_line(const std::string& text) { return !text.empty() && text.find('\n') == text.size() - 1; }

/// A model that cannot be drawn: exit code 1, one line that contains the text, no file left behind.
void refuses(const std::string& path, const std::string& text) {
  const Folder folder;
  const Outcome outcome =
      csgsim("render " + path + " --size 32x32 -o " + (folder / "p.png") + " --stats " + (folder / "s.json"));
  CAPTURE(outcome.err.substr(0, 400));
  CHECK(outcome.code == 1);
  CHECK(one_line(outcome.err));
  CHECK(outcome.err.find(text) != std::string::npos);
  CHECK(folder.files() == 0);
}

void refuses_text(const std::string& csg, const std::string& text) {
  const Folder folder;
  write(folder / "m.csg", csg);
  refuses(folder / "m.csg", text);
}

void misused(const std::string& words, const std::string& text) {
  const Outcome outcome = csgsim(words);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(one_line(outcome.err));
  CHECK(outcome.err.find(text) != std::string::npos);
}

}  // namespace

TEST_CASE("render writes a picture, a depth picture, an owner picture and the stats, and prints a summary") {
  const Folder folder;
  const Outcome outcome =
      csgsim("render " + model("old_example003") + " --size 64x48 -o " + (folder / "p.png") + " --depth " +
             (folder / "z.exr") + " --owner " + (folder / "id.exr") + " --stats " + (folder / "s.json"));
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.find("7 primitives") != std::string::npos);
  CHECK(content(folder / "p.png").substr(1, 3) == "PNG");
  CHECK(fs::file_size(folder / "z.exr") > 100);
  CHECK(fs::file_size(folder / "id.exr") > 100);
  CHECK(folder.files() == 4);
}

TEST_CASE("the stats have the keys that the documentation lists, and their accounts add up") {
  const Folder folder;
  REQUIRE(csgsim("render " + model("carburettor") + " --size 64x64 --stats " + (folder / "s.json")).code == 0);
  const nlohmann::json stats = json(folder / "s.json");
  std::vector<std::string> keys;
  for (const auto& [key, value] : stats.items()) keys.push_back(key);
  CHECK(keys == std::vector<std::string>{"by_primitive", "by_purpose", "clocks", "depth_tests", "effects",
                                         "instructions", "level", "machine", "memory_bits", "model", "pixel_operations",
                                         "scan_conversions", "segments", "simulated_seconds", "strategy",
                                         "wall_seconds"});
  CHECK(stats["model"]["primitives"] == 22);
  CHECK(stats["model"]["unions"] == 11);
  CHECK(stats["model"]["differences"] == 10);
  CHECK(stats["model"]["intersections"] == 0);
  CHECK(stats["model"]["halfspaces"] == 2038);
  std::uint64_t clocks = 0;
  for (const auto& [purpose, cost] : stats["by_purpose"].items()) clocks += cost["clocks"].get<std::uint64_t>();
  CHECK(clocks == stats["clocks"]);
  std::uint64_t named = 0;
  for (const auto& [name, cost] : stats["instructions"]["by_name"].items()) named += cost["count"].get<std::uint64_t>();
  CHECK(named == stats["instructions"]["total"]);
  CHECK(stats["simulated_seconds"].get<double>() == doctest::Approx(stats["clocks"].get<double>() / 1e7));
  CHECK(stats["memory_bits"]["available"] == 72);
}

TEST_CASE("all levels give the same picture, depth, owner and counts") {
  const Folder folder;
  for (const std::string level : {"functional", "cycle", "reference"}) {
    REQUIRE(csgsim("render " + model("thesis_fig_2_3") + " --size 40x30 --projection perspective --level " + level +
                   " -o " + (folder / (level + ".png")) + " --depth " + (folder / (level + "-z.exr")) + " --owner " +
                   (folder / (level + "-id.exr")) + " --stats " + (folder / (level + ".json")))
                .code == 0);
  }
  nlohmann::json expected = json(folder / "functional.json");
  for (const std::string level : {"cycle", "reference"}) {
    for (const std::string ending : {".png", "-z.exr", "-id.exr"})
      CHECK(content(folder / (level + ending)) == content(folder / ("functional" + ending)));
    nlohmann::json stats = json(folder / (level + ".json"));
    for (const std::string key : {"level", "wall_seconds"}) stats[key] = expected[key];
    CHECK(stats == expected);
  }
}

TEST_CASE("a Program runs from its file, in either form, to the picture and the counts of its render") {
  const Folder folder;
  const std::string options = model("old_example002") + " --size 60x50 --camera 65,-95,60,0,0,-2 ";
  REQUIRE(csgsim("render " + options + "-o " + (folder / "a.png") + " --stats " + (folder / "a.json")).code == 0);
  REQUIRE(csgsim("compile " + options + "-o " + (folder / "p.csgt")).code == 0);
  REQUIRE(csgsim("disasm " + (folder / "p.csgt") + " -o " + (folder / "p.txt")).code == 0);
  for (const std::string program : {"p.csgt", "p.txt"}) {
    REQUIRE(
        csgsim("run " + (folder / program) + " -o " + (folder / "b.png") + " --stats " + (folder / "b.json")).code ==
        0);
    CHECK(content(folder / "b.png") == content(folder / "a.png"));
    nlohmann::json a = json(folder / "a.json");
    nlohmann::json b = json(folder / "b.json");
    a.erase("wall_seconds");
    b.erase("wall_seconds");
    CHECK(a == b);
  }
}

TEST_CASE("wave records the window of clocks that was asked for, and a view for GTKWave") {
  const Folder folder;
  const std::string options = "wave " + model("old_example011") + " --size 16x16 --probe 8,8 --probe 0,15 ";
  REQUIRE(csgsim(options + "--window 50:80 -o " + (folder / "w.vcd")).code == 0);
  const std::string wave = content(folder / "w.vcd");
  for (const std::string name :
       {"pixel_8_8", "pixel_0_15", "tree_bit", "carry", "enable", "Z1 [19:0]", "opcode_text", "purpose"}) {
    CHECK(wave.find(name) != std::string::npos);
  }
  // Clock n begins at (n + 1) periods of 100 ns; the last change is at the end of the window.
  const auto last = std::stoull(wave.substr(wave.rfind("\n#") + 2));
  CHECK(last > 80 * 100'000ULL);
  CHECK(last <= 82 * 100'000ULL);
  CHECK(content(folder / "w.gtkw").find("SystemC.pixel_8_8.Z1[19:0]") != std::string::npos);
  CHECK(folder.files() == 2);
}

TEST_CASE("a wave of no pixel, of no clock or under another name is refused and leaves no file") {
  const Folder folder;
  const std::string options = "wave " + model("old_example011") + " --size 16x16 -o " + (folder / "w.vcd ");
  CHECK(csgsim(options + "--probe 16,0").code == 2);
  CHECK(csgsim(options + "--probe 1,1 --window 9:9").code == 2);
  CHECK(csgsim(options + "--probe 1,1 --window 10000000:10000001").code == 1);
  CHECK(csgsim("wave " + model("old_example011") + " --probe 1,1 -o " + (folder / "w.fst")).code == 2);
  CHECK(folder.files() == 0);
}

TEST_CASE("accuracy measures every knob, draws its plots, and measures nothing twice") {
  const Folder folder;
  const std::string command = "accuracy " + model("old_example011") + " --size 48x48 --views 2 -o " + (folder / "a");
  const Outcome first = csgsim(command);
  REQUIRE(first.code == 0);
  const std::string table = content(folder / "a/accuracy.csv");
  for (const std::string knob : {"z-bits", "fraction-bits", "edge-on", "size", "fn", "tolerance", "pareto"}) {
    if (knob != "pareto") CHECK(table.find("\n" + knob + ",") != std::string::npos);
    CHECK(fs::file_size(folder / ("a/" + knob + ".png")) > 1000);
    CHECK(fs::file_size(folder / ("a/" + knob + ".svg")) > 1000);
  }
  CHECK(json(folder / "a/accuracy.json")["points"].size() > 60);
  // As if interrupted: the last two lines are gone, one of them halfway.
  const std::string cut = table.substr(0, table.rfind('\n', table.rfind('\n', table.size() - 2) - 1) - 5);
  write(folder / "a/accuracy.csv", cut);
  const Outcome second = csgsim(command + " --no-plots");
  CHECK(second.code == 0);
  CHECK(content(folder / "a/accuracy.csv") == table);
  CHECK(csgsim(command + " --projection perspective").code == 1);
}

TEST_CASE("sweep writes a table, JSON and plots for every model, and measures nothing twice") {
  const Folder folder;
  const std::string command = "sweep " + model("old_example011") + " " + model("thesis_fig_2_3") +
                              " --size 48x36 --threads 2 -o " + (folder / "s") + " --stack-bits ";
  const Outcome first = csgsim(command + "3..5");
  CHECK(first.err.empty());
  REQUIRE(first.code == 0);
  CHECK(first.out.find("All pictures of a model with the same size and z bits are the same") != std::string::npos);
  CHECK(first.out.find("number of scan-conversions of primitives in active trees") != std::string::npos);
  CHECK(first.out.find("fewest clocks: ") != std::string::npos);
  for (const std::string name : {"old_example011", "thesis_fig_2_3"}) {
    for (const std::string plot : {"_scan_conversions", "_clocks", "_memory"}) {
      for (const std::string ending : {".png", ".svg"})
        CHECK(fs::file_size(folder / ("s/" + name + plot + ending)) > 1000);
    }
  }
  const nlohmann::json points = json(folder / "s/sweep.json")["points"];
  REQUIRE(points.size() == 2 * 6);
  CHECK(points[2]["strategy"] == "bits");
  CHECK(points[2]["stack_bits"] == 3);
  CHECK(points[0]["clocks"] > 0);
  // As if interrupted: the last line is gone, and half of the one before. What is left has a mark, and keeps it.
  const std::string table = content(folder / "s/sweep.csv");
  const std::string hash = points[0]["model_hash"];
  const std::string measured = "," + hash + ",stack,rebroadcast,";
  const std::string marked = "," + hash + ",marked,rebroadcast,";
  std::string expected = table;
  expected.replace(expected.find(measured), measured.size(), marked);
  const std::size_t last = expected.rfind('\n', expected.size() - 2);
  const std::size_t before = expected.rfind('\n', last - 1);
  write(folder / "s/sweep.csv", expected.substr(0, before + 30));
  CHECK(csgsim(command + "3..5 --no-plots").code == 0);
  CHECK(content(folder / "s/sweep.csv") == expected);
  // With other ranges only what is new is measured, and what is known stays.
  REQUIRE(csgsim(command + "6 --no-plots --strategy bits").code == 0);
  CHECK(json(folder / "s/sweep.json")["points"].size() == 2);
  REQUIRE(csgsim(command + "3..5 --no-plots").code == 0);
  CHECK(content(folder / "s/sweep.csv").starts_with(expected));
  CHECK(csgsim(command + "3..5 --no-plots --projection perspective").code == 1);
}

TEST_CASE("an interrupted sweep goes on with the same command") {
  const Folder folder;
  const std::string output = folder / "s";
  const std::string whole = folder / "whole";
  const std::string words = "sweep " + model("carburettor") + " --size 300x300 --strategy bits --stack-bits 3..14" +
                            " --threads 2 --no-plots -o ";
  REQUIRE(csgsim(words + whole).code == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string command = "exec " + std::string(CSGSIM_BINARY_DIR) + "/csgsim " + words + output + " >/dev/null";
    ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    std::_Exit(127);
  }
  const auto lines = [&] {
    const std::string text = content(output + "/sweep.csv");
    return std::count(text.begin(), text.end(), '\n');
  };
  for (int wait = 0; wait < 3000 && lines() < 4; ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  CHECK(lines() >= 4);
  CHECK(lines() < 14);
  REQUIRE(csgsim(words + output).code == 0);
  CHECK(content(output + "/sweep.csv") == content(whole + "/sweep.csv"));
  CHECK(content(output + "/sweep.json") == content(whole + "/sweep.json"));
}

TEST_CASE("a point that does not fit is a row that says why, unless none fits") {
  const Folder folder;
  const std::string command = "sweep " + model("old_example011") +
                              " --size 48x36 --no-plots --strategy stack,list --z-bits 20,24 -o " + (folder / "s");
  const Outcome outcome = csgsim(command + " --memory-bits 70");
  CHECK(outcome.code == 0);
  const nlohmann::json points = json(folder / "s/sweep.json")["points"];
  REQUIRE(points.size() == 4);
  CHECK(points[0]["clocks"] > 0);
  CHECK(!points[2].contains("clocks"));
  CHECK(points[2]["reason"].get<std::string>().find("memory bits") != std::string::npos);
  CHECK(outcome.out.find("2 of 4 points cannot be compiled") != std::string::npos);
  const Outcome none = csgsim(command + " --memory-bits 30");
  CHECK(none.code == 1);
  CHECK(one_line(none.err));
}

TEST_CASE("ranges and names that make no sense are refused before anything is done") {
  const Folder folder;
  const std::string sweep = "sweep " + model("old_example011") + " -o " + (folder / "s") + " ";
  misused(sweep + "--stack-bits 8..3", "3..8");
  misused(sweep + "--stack-bits 2", "3 to 64");
  misused(sweep + "--z-bits 16,", "comma");
  misused(sweep + "--strategy stack,lst", "did you mean list?");
  misused(sweep + "--pruning no-spice", "did you mean no-space?");
  misused(sweep + "--colouring red", "rebroadcast");
  misused(sweep + "--threads 0", "--threads");
  misused("sweep -o " + (folder / "s"), "MODEL");
  CHECK(csgsim(sweep + "--machine pixel-plane-4").err.find("pixel-planes-4") != std::string::npos);
  CHECK(csgsim("sweep none.csg -o " + (folder / "s")).code == 1);
  CHECK(folder.files() == 0);
}

TEST_CASE("render tells how right its picture is, and takes the cheapest settings that are right enough") {
  const Folder folder;
  const std::string options =
      "render " + model("old_example002") + " --size 100x80 --check --stats " + (folder / "s.json");
  REQUIRE(csgsim(options).code == 0);
  const nlohmann::json fine = json(folder / "s.json");
  CHECK(fine["accuracy"]["unexplained"] == 0);
  CHECK(fine["accuracy"]["wrong_pixels"] <= 1);
  REQUIRE(csgsim(options + " --max-wrong-pixels 40").code == 0);
  const nlohmann::json coarse = json(folder / "s.json");
  CHECK(coarse["accuracy"]["wrong_pixels"] <= 40);
  CHECK(coarse["clocks"] < fine["clocks"]);
  CHECK(coarse["machine"]["z_bits"] < 20);
}

TEST_CASE("levels runs a model at every level and finds them equal") {
  const Outcome outcome = csgsim("levels " + model("old_example011") + " --size 40x30");
  CHECK(outcome.code == 0);
  for (const std::string level : {"functional", "cycle", "reference"})
    CHECK(outcome.out.find(level) != std::string::npos);
  CHECK(outcome.out.find("DIFFERENT") == std::string::npos);
}

TEST_CASE("every command has help with an example") {
  for (const std::string command :
       {"render", "compile", "run", "disasm", "wave", "accuracy", "sweep", "levels", "machines", "isa"}) {
    const Outcome outcome = csgsim(command + " --help");
    CAPTURE(command);
    CHECK(outcome.code == 0);
    CHECK(outcome.out.find("Example:\n  csgsim " + command) != std::string::npos);
  }
}

TEST_CASE("machines says where each figure comes from") {
  const Outcome outcome = csgsim("machines");
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find("pixel-planes-4") != std::string::npos);
  CHECK(outcome.out.find("published") != std::string::npos);
  CHECK(outcome.out.find("assumed") != std::string::npos);
}

TEST_CASE("the instruction set's page in docs is the one that csgsim prints") {
  CHECK(csgsim("isa").out == content(std::string(CSGSIM_SOURCE_DIR) + "/docs/instruction-set.md"));
}

TEST_CASE("bad usage ends with exit code 2 and one line") {
  misused("", "subcommand");
  misused("rendr x.csg", "rendr");
  misused("render", "MODEL");
  misused("render m.csg --colour", "--colour");
  misused("render m.csg --level gate", "gate");
  misused("render m.csg --size 12", "WxH");
  misused("render m.csg --size 12x-4", "WxH");
  misused("render " + model("old_example003") + " --camera 1,2,3", "ex,ey,ez,cx,cy,cz");
  misused("render m.csg --z-bits many", "--z-bits");
  misused("compile m.csg", "--output");
}

TEST_CASE("a missing file, a directory, an empty file and a syntax error are refused in one line") {
  const Folder folder;
  refuses(folder / "none.csg", "none.csg");
  fs::create_directory(folder / "dir.csg");
  refuses(folder / "dir.csg", "dir.csg");
  refuses_text("", "m.csg");
  refuses_text("cube(size = [1, 2, 3]", "m.csg:1:");
  refuses_text("union() {\n cube(size = 1);\n", "m.csg:");
  refuses_text("sphere(r = 1e999);", "m.csg:1:");
}

TEST_CASE("a node that cannot be turned into half-spaces is named with its place") {
  refuses(model("old_example006"), "old_example006.csg:5:5: hull()");
  refuses_text("union() {\n  linear_extrude(height = 3) { square(size = 2); }\n}", "m.csg:2:3: linear_extrude()");
}

TEST_CASE("a hundred megabytes of brackets are refused quickly") {
  const Folder folder;
  for (const std::string bracket : {"{", "(", "[", "group(){", "cube([", "}"}) {
    std::string text;
    while (text.size() < 100'000'000) text += bracket;
    write(folder / "m.csg", text);
    refuses(folder / "m.csg", "m.csg:");
  }
}

TEST_CASE("a machine that cannot hold the picture says what is missing") {
  refuses(model("old_example002") + " --memory-bits 40", "--memory-bits");
  refuses(model("old_example002") + " --z-bits 31", "4 to 30 bits");
  refuses(model("old_example002") + " --machine pixel-plane-4", "pixel-planes-4");
}

TEST_CASE("a picture's name without a format, or in no folder, is refused and nothing is left behind") {
  const Folder folder;
  const std::string options = "render " + model("old_example011") + " --size 16x16 ";
  CHECK(csgsim(options + "-o " + (folder / "picture.xyz")).code == 1);
  CHECK(csgsim(options + "-o " + (folder / "none/picture.png")).code == 1);
  CHECK(csgsim(options + "--stats " + (folder / "none/s.json")).code == 1);
  CHECK(folder.files() == 0);
}

TEST_CASE("a broken Program file is refused") {
  const Folder folder;
  write(folder / "p.csgt", "CSGT but not really");
  CHECK(csgsim("run " + (folder / "p.csgt")).code == 1);
  CHECK(csgsim("disasm " + (folder / "p.csgt")).code == 1);
  CHECK(csgsim("run " + (folder / "none.csgt")).code == 1);
}

TEST_CASE("a model of nothing gives an empty picture") {
  const Folder folder;
  write(folder / "m.csg", "cube(size = 0);");
  CHECK(csgsim("render " + (folder / "m.csg") + " --size 16x16 -o " + (folder / "p.png")).code == 0);
}

TEST_CASE("an output that is a symbolic link stays one, and what it leads to is written") {
  const Folder folder;
  fs::create_directory(folder / "real");
  write(folder / "real/old.png", "old");
  fs::create_symlink("real/old.png", folder / "old.png");
  fs::create_symlink("real/new.json", folder / "new.json");
  REQUIRE(csgsim("render " + model("old_example011") + " --size 16x16 -o " + (folder / "old.png") + " --stats " +
                 (folder / "new.json"))
              .code == 0);
  CHECK(fs::is_symlink(folder / "old.png"));
  CHECK(fs::is_symlink(folder / "new.json"));
  CHECK(content(folder / "real/old.png").substr(1, 3) == "PNG");
  CHECK(json(folder / "real/new.json")["machine"]["width"] == 16);
  CHECK(folder.files() == 3);
}

TEST_CASE("an output that is a pipe stays one and gets the whole file") {
  const Folder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  for (const std::string& words : {"render " + model("old_example011") + " --size 16x16 --stats ",
                                   "compile " + model("old_example011") + " --size 16x16 -o "}) {
    std::string received;
    std::thread reader([&] { received = content(folder / "pipe"); });
    const int code = csgsim(words + (folder / "pipe")).code;
    if (code != 0) ::close(::open((folder / "pipe").c_str(), O_WRONLY | O_NONBLOCK));
    reader.join();
    CHECK(code == 0);
    CHECK(received.size() > 100);
  }
  CHECK(fs::is_fifo(folder / "pipe"));
  CHECK(folder.files() == 1);
}

TEST_CASE("standard output can be an output") {
  const Outcome outcome = csgsim("render " + model("old_example011") + " --size 16x16 --stats /dev/stdout");
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find("\"by_purpose\"") != std::string::npos);
  CHECK(outcome.out.find("simulated in") != std::string::npos);
}

TEST_CASE("a folder is no output") {
  const Folder folder;
  fs::create_directory(folder / "d.png");
  const Outcome outcome = csgsim("render " + model("old_example011") + " --size 16x16 -o " + (folder / "d.png"));
  CHECK(outcome.code == 1);
  CHECK(one_line(outcome.err));
  CHECK(folder.files() == 1);
}

TEST_CASE("an interrupted command leaves no file behind") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Folder folder;
    const std::string binary = std::string(CSGSIM_BINARY_DIR) + "/csgsim";
    const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/terrain_vehicle.csgt";
    const std::string output = folder / "long.vcd";
    const pid_t child = ::fork();
    if (child == 0) {
      ::execl(binary.c_str(), "csgsim", "wave", program.c_str(), "--probe", "1,1", "--window", "0:1000000", "-o",
              output.c_str(), static_cast<char*>(nullptr));
      std::_Exit(127);
    }
    for (int wait = 0; wait < 500 && folder.files() == 0; ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(folder.files() > 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(folder.files() == 0);
  }
}

TEST_CASE("a Program that overflows is refused at every level, with the same count") {
  const Folder folder;
  std::string text = csgsim("disasm " + std::string(CSGSIM_SOURCE_DIR) + "/traces/old_example002.csgt").out;
  const std::string wide = "(w34 >> 12)";
  REQUIRE(text.find(wide) != std::string::npos);
  for (std::size_t at = text.find(wide); at != std::string::npos; at = text.find(wide, at))
    text.replace(at, wide.size(), "(w33 >> 12)");
  write(folder / "p.txt", text);
  const std::string run = "run " + (folder / "p.txt") + " -o " + (folder / "p.png") + " --level ";
  const Outcome expected = csgsim(run + "reference");
  CHECK(expected.code == 1);
  CHECK(expected.err.find("overflows") != std::string::npos);
  for (const std::string level : {"functional", "cycle"}) {
    const Outcome outcome = csgsim(run + level);
    CHECK(outcome.code == 1);
    CHECK(outcome.err == expected.err);
  }
  const Outcome wave = csgsim("wave " + (folder / "p.txt") + " --probe 1,1 -o " + (folder / "w.vcd"));
  CHECK(wave.code == 1);
  CHECK(wave.err == expected.err);
  CHECK(folder.files() == 1);
}

TEST_CASE("outputs that cannot be are told before anything is simulated, and leave nothing") {
  const Folder folder;
  const std::string wave = "wave " + model("old_example011") + " --size 16x16 --probe 1,1 -o ";
  const Outcome no_folder = csgsim(wave + (folder / "none/w.vcd"));
  CHECK(no_folder.code == 1);
  CHECK(one_line(no_folder.err));
  const std::string render = "render " + model("old_example011") + " --size 16x16 ";
  CHECK(csgsim(render + "-o " + (folder / "p.png") + " --stats " + (folder / "none/s.json")).code == 1);
  misused(render + "--depth " + (folder / "z.png"), ".exr");
  misused(render + "--owner " + (folder / "o.jpg"), ".exr");
  misused(render + "-o " + (folder / "p.exr") + " --depth " + (folder / "none/../p.exr"), "same file");
  CHECK(folder.files() == 0);
}

TEST_CASE("standard output that cannot be written is told") {
  if (!fs::exists("/dev/full")) return;
  const Folder folder;
  const std::string binary = std::string(CSGSIM_BINARY_DIR) + "/csgsim ";
  const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt";
  for (const std::string& words : {"disasm " + program, std::string("isa"), std::string("machines")}) {
    const int status = std::system((binary + words + " >/dev/full 2>" + (folder / "err")).c_str());
    CHECK(WEXITSTATUS(status) == 1);
    CHECK(one_line(content(folder / "err")));
  }
}

TEST_CASE("models and Programs are told from each other by name") {
  const Folder folder;
  const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt";
  CHECK(csgsim("render " + program).err.find("use csgsim run") != std::string::npos);
  CHECK(csgsim("run " + model("old_example011")).err.find("use csgsim render") != std::string::npos);
  misused("wave " + program + " --probe 1,1 --size 16x16 -o " + (folder / "w.vcd"), "--size");
  misused("wave " + program + " --probe 1,1 --view-all -o " + (folder / "w.vcd"), "--view-all");
  fs::copy_file(model("old_example011"), folder / "M.CSG");
  CHECK(csgsim("wave " + (folder / "M.CSG") + " --size 16x16 --probe 1,1 -o " + (folder / "w.vcd")).code == 0);
}

TEST_CASE("a machine's folder and a clock too fast are refused") {
  const Folder folder;
  fs::create_directory(folder / "m.toml");
  CHECK(csgsim("machines " + (folder / "m.toml")).code == 1);
  std::string text = content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml");
  const std::size_t at = text.find("10_000_000");
  if (at != std::string::npos) text.replace(at, 10, "1_000_000_001");
  write(folder / "fast.toml", text);
  CHECK(csgsim("machines " + (folder / "fast.toml")).code == (at == std::string::npos ? 0 : 1));
}

TEST_CASE("a word that is like no known one gets no suggestion") {
  misused("rendr x.csg", "did you mean render?");
  CHECK(csgsim("xyzzy").err.find("did you mean") == std::string::npos);
  CHECK(csgsim("render m.csg --quixotic").err.find("did you mean") == std::string::npos);
}

TEST_CASE("a view for GTKWave names a field as the waveform does") {
  const Folder folder;
  std::string text = csgsim("disasm " + std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt").out;
  for (std::size_t at = text.find("Z1"); at != std::string::npos; at = text.find("Z1", at))
    text.replace(at, 2, "\"Z-1\"");
  write(folder / "p.txt", text);
  REQUIRE(csgsim("wave " + (folder / "p.txt") + " --probe 1,1 --window 0:9 -o " + (folder / "w.vcd")).code == 0);
  CHECK(content(folder / "w.vcd").find("Z_1") != std::string::npos);
  CHECK(content(folder / "w.gtkw").find(".Z_1[") != std::string::npos);
}

#ifndef __SANITIZE_ADDRESS__  // which reserves more address space than the limit
TEST_CASE("a picture that memory does not hold is told with its size") {
  const Folder folder;
  const std::string command = "ulimit -v 600000; " + std::string(CSGSIM_BINARY_DIR) + "/csgsim render " +
                              model("old_example011") + " --size 12000x11000 -o " + (folder / "p.png") + " 2>&1";
  FILE* const pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text(1000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), pipe));
  CHECK(WEXITSTATUS(::pclose(pipe)) == 1);
  CHECK(one_line(text));
  CHECK(text.find("memory for a picture of 12000 x 11000") != std::string::npos);
  CHECK(folder.files() == 0);
}
#endif
