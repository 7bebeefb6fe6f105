#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string small = " --size 48x48 --progress none";
const std::string vary = " --vary alu.bits=1,4 --vary z-bits=8,16 --vary strategy=stack,list";

/// The arguments of a command that csgsim printed without quotes.
std::string words_of(const std::string& command) {
  REQUIRE(command.starts_with("csgsim "));
  REQUIRE(command.find_first_of("'\"\\") == std::string::npos);
  return command.substr(7);
}

std::string without_line(const std::string& table, std::size_t number) {
  std::istringstream lines(table);
  std::string rest;
  std::string line;
  for (std::size_t i = 0; std::getline(lines, line); ++i)
    if (i != number) rest += line + "\n";
  return rest;
}

}  // namespace

TEST_CASE("explore measures every design on every model and plots the Pareto front") {
  const Folder folder;
  const Outcome outcome =
      require_success(run("explore " + model("old_example011") + " " + model("thesis_fig_2_3") + small + vary +
                          " --report " + (folder / "p.html") + " -o " + (folder / "e")));
  CHECK(outcome.err.empty());
  const nlohmann::json file = json(folder / "e/explore.json");
  REQUIRE(file["points"].size() == 2 * 8);
  REQUIRE(file["fronts"].size() == 3);
  const nlohmann::json& first = file["points"][0];
  CHECK(first["machine"] == "pixel-planes-4+alu.bits=1");
  CHECK(first["design"] == nlohmann::json{{"alu.bits", 1}, {"z-bits", 8}, {"strategy", "stack"}});
  CHECK(first["machine_memory_bits"] == 48 * 48 * first["used_bits"].get<int>());
  std::size_t on_front = 0;
  for (const nlohmann::json& point : file["points"]) on_front += point["pareto"] == true ? 1U : 0U;
  CHECK(on_front == file["fronts"][0]["front"].size() + file["fronts"][1]["front"].size());
  CHECK(on_front < 16);
  for (const std::string plot : {"old_example011_front", "thesis_fig_2_3_front", "all_models_front"})
    for (const std::string ending : {".png", ".svg"})
      CHECK(fs::file_size(folder.path() / "e" / (plot + ending)) > 1000);
  CHECK(outcome.out.find("All models: ") != std::string::npos);
  CHECK(content(folder / "p.html").find("Commands that draw the knees") != std::string::npos);
}

TEST_CASE("a design's row equals the counts of render and the wrong pixels of accuracy") {
  const Folder folder;
  const std::string of = model("rietveld_house") + " --size 64x64 --camera 3430,-2900,1950,590,230,220";
  require_success(run("explore " + of + " --vary memory.reads=1,2 --vary z-bits=8,20 --no-plots --progress none -o " +
                      (folder / "e")));
  REQUIRE(run("accuracy " + of + " --knobs z-bits --views 1 --no-plots --progress none -o " + (folder / "a")).code ==
          0);
  std::map<unsigned, std::uint64_t> wrong;
  const nlohmann::json turned = json(folder / "a/accuracy.json")["points"];
  for (const nlohmann::json& point : turned)
    wrong[static_cast<unsigned>(std::stoul(point["value"].get<std::string>()))] = point["wrong"];
  const nlohmann::json points = json(folder / "e/explore.json")["points"];
  REQUIRE(points.size() == 4);
  for (const nlohmann::json& point : points) {
    CHECK(point["wrong"] == wrong.at(point["z_bits"]));
    require_success(run("render " + of + " --machine " + point["machine"].get<std::string>() + " --memory-bits " +
                        std::to_string(point["used_bits"].get<unsigned>()) + " --z-bits " +
                        std::to_string(point["z_bits"].get<unsigned>()) + " --stats " + (folder / "s.json")));
    const nlohmann::json stats = json(folder / "s.json");
    CHECK(point["clocks"] == stats["clocks"]);
    CHECK(point["interval_clocks"] == stats["interval_clocks"]);
    CHECK(point["used_bits"] == stats["memory"]["used_bits"]);
  }
  CHECK(wrong.at(8) > wrong.at(20));
}

TEST_CASE("the command printed for the knee reproduces the counts of its row") {
  const Folder folder;
  const std::string scene = " --camera 42,-38,41,10,5.5,2 --set background.colour=0,0,0.5";
  REQUIRE(run("explore " + model("thesis_fig_2_3") + small + scene + vary + " --no-plots -o " + (folder / "e")).code ==
          0);
  const nlohmann::json file = json(folder / "e/explore.json");
  const nlohmann::json commands = file["fronts"][0]["knee"]["commands"];
  REQUIRE(commands.size() == 1);
  const std::string command = commands[0];
  CHECK(command.find("--camera") != std::string::npos);
  const std::string words = words_of(command.substr(0, command.find(" --output")));
  require_success(run(words + " --stats " + (folder / "s.json")));
  std::size_t knees = 0;
  for (const nlohmann::json& point : file["points"]) {
    if (point["knee"] != true) continue;
    ++knees;
    CHECK(json(folder / "s.json")["clocks"] == point["clocks"]);
  }
  CHECK(knees == 1);
}

TEST_CASE("the knee's commands reserve enough memory for several models in any order") {
  const Folder folder;
  const std::string words = small + " --vary z-bits=16 --vary strategy=stack --no-plots -o ";
  const auto bits_of = [&](const std::string& models, const std::string& output) {
    require_success(run("explore " + models + words + (folder / output)));
    const nlohmann::json file = json(folder / output + "/explore.json");
    unsigned most = 0;
    for (const nlohmann::json& point : file["points"]) most = std::max(most, point["used_bits"].get<unsigned>());
    CHECK(file["points"][0]["used_bits"] != file["points"][1]["used_bits"]);
    const nlohmann::json commands = file["fronts"].back()["knee"]["commands"];
    REQUIRE(commands.size() == 2);
    for (const nlohmann::json& command : commands)
      CHECK(command.get<std::string>().find("--memory-bits " + std::to_string(most) + " ") != std::string::npos);
    return most;
  };
  const std::string one = model("sphere");
  const std::string other = model("carburettor");
  CHECK(bits_of(one + " " + other, "a") == bits_of(other + " " + one, "b"));
}

TEST_CASE("explore remeasures after an edit of any parameter in a process file") {
  const Folder folder;
  std::string process = content(std::string(CSGSIM_SOURCE_DIR) + "/hw/process/nmos-3um.toml");
  process.replace(process.find("\"nmos-3um\""), 10, "\"mine\"");
  write(folder / "c.csg", "cube(size = [8, 6, 4]);\n");
  const std::string command = "explore " + (folder / "c.csg") + " --size 16x16 --progress none --process " +
                              (folder / "p.toml") + " --vary alu.bits=1,2 --no-plots -o ";
  const auto measured = [&](const std::string& output) {
    require_success(run(command + (folder / output)));
    return json(folder / output + "/explore.json")["points"];
  };
  write(folder / "p.toml", process);
  const nlohmann::json before = measured("kept");
  std::size_t edits = 0;
  std::size_t differ = 0;
  for (std::size_t at = process.find("\nvalue = "); at != process.npos; at = process.find("\nvalue = ", at + 1)) {
    const std::size_t begin = at + std::string("\nvalue = ").size();
    const std::size_t end = process.find('\n', begin);
    std::string digits = process.substr(begin, end - begin);
    std::erase(digits, '_');
    std::string edited = process;
    const bool is_family = digits == "\"nmos\"";
    edited.replace(begin, end - begin, is_family ? "\"cmos\"" : std::to_string(std::stoull(digits) / 2));
    write(folder / "p.toml", edited);
    CAPTURE(edited.substr(edited.rfind('[', at), 40));
    const nlohmann::json again = measured("kept");
    CHECK(again[0]["process"] == "mine");
    CHECK(again == measured("fresh" + std::to_string(++edits)));
    differ += again == before ? 0U : 1U;
  }
  CHECK(edits == 20);
  CHECK(differ > 10);  // another fan-in may not change a small machine
  write(folder / "p.toml", process);
  CHECK(measured("kept") == before);
}

TEST_CASE("explore resumes an interrupted run and measures only new values") {
  const Folder folder;
  const std::string command =
      "explore " + model("old_example011") + small + " --no-plots -o " + (folder / "e") + " --vary z-bits=";
  require_success(run(command + "8,12,16"));
  const std::string table = content(folder / "e/explore.csv");
  // Simulates an interruption; the marked line must stay unchanged.
  std::string marked = table;
  const std::string csgsim = json(folder / "e/explore.json")["points"][0]["csgsim"];
  const std::string measured = "," + csgsim + ",";
  const std::size_t halfspaces = marked.find(measured) + measured.size();
  marked.insert(halfspaces, "1");
  write(folder / "e/explore.csv", without_line(marked, 3));
  require_success(run(command + "8,12,16"));
  CHECK(content(folder / "e/explore.csv") == marked);
  require_success(run(command + "8,10,12,16 --axes time,wrong"));
  CHECK(json(folder / "e/explore.json")["points"].size() == 4);
  CHECK(json(folder / "e/explore.json")["fronts"][0]["axes"] == nlohmann::json{"time", "wrong"});
  CHECK(run(command + "8 --projection perspective").code == 1);
}

TEST_CASE("gathering shards of explore gives the results of one process") {
  const Folder folder;
  const std::string command =
      "explore " + model("old_example011") + " " + model("sphere") + small + vary + " --no-plots";
  require_success(run(command + " -o " + (folder / "whole")));
  const std::string in_parts = command + " -o " + (folder / "parts") + " --shard ";
  for (const char* const shard : {"1/3", "2/3", "3/3"}) REQUIRE(run(in_parts + shard).code == 0);
  require_success(run("gather " + (folder / "parts") + " --no-plots"));
  for (const char* const file : {"explore.csv", "explore.json"})
    CHECK(content(folder.path() / "parts" / file) == content(folder.path() / "whole" / file));
}

TEST_CASE("explore samples the requested number of designs and can extend the sample") {
  const Folder folder;
  const std::string command = "explore " + model("sphere") + small + " --no-plots -o " + (folder / "e") +
                              " --vary z-bits=4..30 --vary fraction-bits=0..16 --vary link.width=8,16,32 "
                              "--vary clock.frequency=1000000..1000900";
  check_misuse(command, "use --points N");
  require_success(run(command + " --points 5"));
  const nlohmann::json few = json(folder / "e/explore.json")["points"];
  REQUIRE(few.size() == 5);
  require_success(run(command + " --points 8"));
  const nlohmann::json more = json(folder / "e/explore.json")["points"];
  REQUIRE(more.size() == 8);
  for (std::size_t i = 0; i < few.size(); ++i) CHECK(more[i]["design"] == few[i]["design"]);
}

TEST_CASE("designs that cannot draw the model give a reason and do not stop the others") {
  const Folder folder;
  const Outcome outcome = require_success(run("explore " + model("carburettor") + small + " --no-plots -o " +
                                              (folder / "e") + " --vary array.memory_bits=20,72"));
  const nlohmann::json file = json(folder / "e/explore.json");
  CHECK(file["points"][0]["reason"] != "");
  CHECK(file["points"][0].contains("pareto") == false);
  CHECK(file["points"][1]["memory_bits"] == 72);
  CHECK(file["points"][1]["machine_memory_bits"] == 48 * 48 * 72);
  CHECK(file["fronts"][0]["refused"] == 1);
  CHECK(outcome.out.find("1 cannot be drawn") != std::string::npos);
  const std::string reason = file["points"][0]["reason"];
  CHECK(outcome.out.find("\n  array.memory_bits=20, memory-bits=20 cannot be drawn: " + reason + "\n") !=
        std::string::npos);
  const Outcome none = run("explore " + model("carburettor") + small + " --no-plots -o " + (folder / "n") +
                           " --vary array.memory_bits=20,21");
  CHECK(none.code == 1);
  CHECK(is_one_line(none.err));
}

TEST_CASE("explore writes nothing if no model can be read") {
  const Folder folder;
  const std::string words = small + " --vary z-bits=8,16 --no-plots -o " + (folder / "e");
  fails(run("explore " + (folder / "nosuch.csg") + words), 1, {"nosuch.csg: cannot be read"});
  CHECK(folder.files() == 0);
}

TEST_CASE("explore omits the area axis for machines without transistor counts") {
  const Folder folder;
  require_success(run("explore " + model("thesis_fig_2_3") + small +
                      " --machine scan-line --vary chains.count=1,4 --no-plots -o " + (folder / "e")));
  const nlohmann::json file = json(folder / "e/explore.json");
  CHECK(file["points"][0]["machine_transistors"].is_null());
  CHECK(file["fronts"][0]["axes"] == nlohmann::json{"time", "memory", "wrong"});
}

TEST_CASE("explore varies dependent parameters together and explains invalid combinations") {
  const Folder folder;
  require_success(run("explore " + model("thesis_fig_2_3") + small +
                      " --vary evaluator.bits=1,4 --vary alu.bits=1,4 --no-plots -o " + (folder / "e")));
  std::size_t refused = 0;
  std::map<std::string, std::uint64_t> clocks;
  const nlohmann::json points = json(folder / "e/explore.json")["points"];
  for (const nlohmann::json& point : points) {
    if (const std::string reason = point["reason"].is_null() ? "" : point["reason"].get<std::string>();
        !reason.empty()) {
      CHECK(reason.find("evaluator.bits is 4 and alu.bits 1") != std::string::npos);
      ++refused;
    } else {
      clocks[point["machine"]] = point["clocks"];
    }
  }
  CHECK(refused == 1);
  REQUIRE(clocks.size() == 3);
  CHECK(2 * clocks.at("pixel-planes-4+evaluator.bits=4+alu.bits=4") <
        clocks.at("pixel-planes-4+evaluator.bits=1+alu.bits=4"));
}

TEST_CASE("explore reports an error in --vary or --axes in one line with a suggestion") {
  const Folder folder;
  const std::string command = "explore " + model("sphere") + small + " -o " + (folder / "e");
  check_misuse(command, "--vary");
  check_misuse(command + " --vary alu.bits", "use KEY=a,b,c");
  check_misuse(command + " --vary alu.bit=1", "did you mean 'alu.bits'?");
  check_misuse(command + " --vary alu.bits=1,999", "--vary alu.bits");
  check_misuse(command + " --vary evaluator.bits=1,4", "the ALU must process all bits that the trees deliver");
  check_misuse(command + " --vary strategy=auto", "strategy");
  check_misuse(command + " --vary alu.bits=1,2 --set alu.bits=4", "is both varied and fixed");
  check_misuse(command + " --vary alu.bits=1,2 --vary alu.bits=4", "is given twice");
  check_misuse(command + " --vary array.width=48,64", "an option overrides array.width=64");
  check_misuse(command + " --vary array.memory_bits=72,96 --vary memory-bits=80", "an option overrides");
  check_misuse(command + " --vary alu.bits=1,2 --axes tim", "did you mean time");
  check_misuse(command + " --vary alu.bits=1,2 --points 100000", "--points");
  CHECK(folder.files() == 0);
}

TEST_CASE("explore --process sets the machine's clock and the knee's command states it") {
  const Folder folder;
  require_success(run("explore " + model("thesis_fig_2_3") + small +
                      " --process cmos-45nm --vary alu.bits=1,8 --vary z-bits=8,20" + " --no-plots -o " +
                      (folder / "e")));
  const nlohmann::json file = json(folder / "e/explore.json");
  CHECK(file["fronts"][0]["axes"] == nlohmann::json{"time", "silicon", "energy", "memory", "wrong"});
  for (const nlohmann::json& point : file["points"]) {
    CHECK(point["process"] == "cmos-45nm");
    CHECK(point["clock_path"] == "pixel");
    CHECK(point["machine_mm2"] > 0);
    CHECK(point["frame_joules"] > 0);
    if (point["knee"] != true) continue;
    const std::string command = file["fronts"][0]["knee"]["commands"][0];
    CHECK(command.find("+clock.frequency=" + std::to_string(point["clock_hz"].get<std::uint64_t>())) !=
          std::string::npos);
    const std::string words = words_of(command.substr(0, command.find(" --output")));
    require_success(run(words + " --stats " + (folder / "s.json")));
    CHECK(json(folder / "s.json")["frames_per_second"].get<double>() ==
          doctest::Approx(point["frames_per_second"].get<double>()));
  }
  CHECK(file["points"][0]["clock_hz"] > file["points"][2]["clock_hz"]);
}

TEST_CASE("an unsynthesized machine has no area and a changed process is measured again") {
  const Folder folder;
  const std::string command = "explore " + model("thesis_fig_2_3") + small + " --no-plots -o " + (folder / "e");
  require_success(run(command + " --machine scan-line --process nmos-3um --vary chains.count=1,4"));
  nlohmann::json points = json(folder / "e/explore.json")["points"];
  CHECK(points[0]["machine_mm2"].is_null());
  CHECK(points[0]["frame_joules"].is_null());
  CHECK(points[0]["clock_path"] == "");
  CHECK(points[0]["clock_hz"] == 10'000'000);
  require_success(run("manual processes nmos-3um"));
  require_success(run(command + " --process nmos-3um --vary alu.bits=1"));
  const nlohmann::json slow = json(folder / "e/explore.json")["points"][0];
  require_success(run(command + " --process nmos-3um+gate.delay=1000 --vary alu.bits=1"));
  points = json(folder / "e/explore.json")["points"];
  CHECK(points[0]["process"] == "nmos-3um+gate.delay=1000");
  CHECK(points[0]["clock_hz"] > slow["clock_hz"]);
  check_misuse("explore " + model("sphere") + small + " -o " + (folder / "n") + " --vary alu.bits=1 --process nmos-3",
               "did you mean nmos-3um");
  check_misuse("explore " + model("sphere") + small + " -o " + (folder / "n") +
                   " --vary clock.frequency=1000,2000 --process nmos-3um",
               "the process determines the clock");
}

TEST_CASE("a search tries every neighbour of the front and resumes but cannot be sharded") {
  const Folder folder;
  const std::string search = "explore " + model("old_example011") + small +
                             " --vary z-bits=8..20 --vary fraction-bits=0..12 --axes memory,wrong --no-plots -o " +
                             (folder / "e") + " --points 4 --search ";
  require_success(run(search + "500"));
  const std::string table = content(folder / "e/explore.csv");
  std::map<std::pair<int, int>, bool> on_front;
  const nlohmann::json points = json(folder / "e/explore.json")["points"];
  for (const nlohmann::json& point : points) on_front[{point["z_bits"], point["fraction_bits"]}] = point["pareto"];
  CHECK(on_front.size() > 20);
  CHECK(on_front.size() < 13 * 13);
  for (const auto& [design, is_on] : on_front) {
    if (!is_on) continue;
    const auto [z_bits, fraction_bits] = design;
    for (const int by : {-1, 1}) {
      if (z_bits + by >= 8 && z_bits + by <= 20) CHECK(on_front.contains({z_bits + by, fraction_bits}));
      if (fraction_bits + by >= 0 && fraction_bits + by <= 12) CHECK(on_front.contains({z_bits, fraction_bits + by}));
    }
  }
  std::ofstream(folder / "e/explore.csv") << without_line(without_line(table, 20), 9);
  require_success(run(search + "500"));
  CHECK(content(folder / "e/explore.csv") == table);
  require_success(run(search + "10"));
  CHECK(json(folder / "e/explore.json")["points"].size() == 14);
  fails(run(search + "10 --shard 1/2"), 2, {"a search depends on earlier results"});
}
