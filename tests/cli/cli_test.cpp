#include "tests/cli/cli.h"

#include "places.h"

using namespace csgsim::testing::cli;

TEST_CASE("render writes pictures and stats and prints a summary") {
  const Folder folder;
  const Outcome outcome =
      run("render " + model("old_example003") + " --size 64x48 -o " + (folder / "p.png") + " --depth " +
          (folder / "z.exr") + " --owner " + (folder / "id.exr") + " --stats " + (folder / "s.json"));
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.find("7 primitives") != std::string::npos);
  CHECK(content(folder / "p.png").substr(1, 3) == "PNG");
  CHECK(fs::file_size(folder / "z.exr") > 100);
  CHECK(fs::file_size(folder / "id.exr") > 100);
  CHECK(folder.files() == 4);
}

TEST_CASE("the stats have the documented keys and their accounts add up") {
  const Folder folder;
  require_success(run("render " + model("carburettor") + " --size 64x64 --stats " + (folder / "s.json")));
  const nlohmann::json stats = json(folder / "s.json");
  std::vector<std::string> keys;
  for (const auto& [key, value] : stats.items()) keys.push_back(key);
  CHECK(keys == std::vector<std::string>{"account",
                                         "bound_by",
                                         "by_effect",
                                         "by_primitive",
                                         "by_purpose",
                                         "clocks",
                                         "configuration",
                                         "dearest",
                                         "depth_tests",
                                         "effects",
                                         "frame_joules",
                                         "frame_seconds",
                                         "frames_per_second",
                                         "host_clocks",
                                         "host_model_clocks",
                                         "hosted_frames_per_second",
                                         "instructions",
                                         "interval_clocks",
                                         "knobs",
                                         "level",
                                         "machine",
                                         "memory",
                                         "model",
                                         "pixel_operations",
                                         "prunings",
                                         "scan_conversions",
                                         "segments",
                                         "shown_clocks",
                                         "simulated_seconds",
                                         "strategy_used",
                                         "wall_seconds"});
  CHECK(stats["model"]["primitives"] == 22);
  CHECK(stats["model"]["unions"] == 11);
  CHECK(stats["model"]["differences"] == 10);
  CHECK(stats["model"]["intersections"] == 0);
  CHECK(stats["model"]["halfspaces"] == 2038);
  std::uint64_t clocks = 0;
  for (const auto& [purpose, cost] : stats["by_purpose"].items()) clocks += cost["clocks"].get<std::uint64_t>();
  const nlohmann::json& controller = stats["account"]["parts"]["controller"];
  for (const std::string activity : {"clearing", "starved", "jumping"})
    clocks += controller[activity].get<std::uint64_t>();
  CHECK(clocks == stats["clocks"]);
  std::uint64_t charged = 0;
  for (const auto& [name, cost] : stats["by_effect"].items()) charged += cost["instructions"].get<std::uint64_t>();
  CHECK(charged == stats["instructions"]["total"]);
  std::uint64_t named = 0;
  for (const auto& [name, cost] : stats["instructions"]["by_name"].items()) named += cost["count"].get<std::uint64_t>();
  CHECK(named == stats["instructions"]["total"]);
  CHECK(stats["simulated_seconds"].get<double>() == doctest::Approx(stats["clocks"].get<double>() / 1e7));
  CHECK(stats["memory"]["memory_bits"] == 72);
}

TEST_CASE("render gives the same pictures and counts at all levels") {
  const Folder folder;
  for (const std::string level : {"functional", "cycle", "reference"}) {
    require_success(run("render " + model("thesis_fig_2_3") + " --size 40x30 --projection perspective --level " +
                        level + " -o " + (folder / (level + ".png")) + " --depth " + (folder / (level + "-z.exr")) +
                        " --owner " + (folder / (level + "-id.exr")) + " --stats " + (folder / (level + ".json"))));
  }
  nlohmann::json expected = json(folder / "functional.json");
  for (const std::string level : {"cycle", "reference"}) {
    for (const std::string ending : {".png", "-z.exr", "-id.exr"})
      CHECK(content(folder / (level + ending)) == content(folder / ("functional" + ending)));
    nlohmann::json stats = json(folder / (level + ".json"));
    for (const std::string key : {"level", "wall_seconds", "configuration"}) stats[key] = expected[key];
    CHECK(stats == expected);
  }
}

TEST_CASE("both levels draw the same frames of a sequence and report its frame rate") {
  const Folder folder;
  const std::string options = model("thesis_fig_2_3") + " --size 40x30 --view-all --frames 3 --orbit 60 ";
  const auto functional = run("render " + options + "-o " + (folder / "f.png"));
  const auto cycle = run("render " + options + "--level cycle -o " + (folder / "c.png"));
  REQUIRE(functional.code == 0);
  REQUIRE(cycle.code == 0);
  CHECK(folder.files() == 6);
  for (const std::string number : {"_000.png", "_001.png", "_002.png"})
    CHECK(content(folder / ("c" + number)) == content(folder / ("f" + number)));
  CHECK(content(folder / "f_000.png") != content(folder / "f_001.png"));
  CHECK(cycle.out.substr(0, cycle.out.find(';')) == functional.out.substr(0, functional.out.find(';')));
  CHECK(cycle.out.find(" frames per second") != std::string::npos);
  require_success(run("render " + model("thesis_fig_2_3") + " --size 40x30 --view-all -o " + (folder / "one.png")));
  CHECK(content(folder / "one.png") == content(folder / "f_000.png"));
}

TEST_CASE("running a compiled Program in either form reproduces render's picture and counts") {
  const Folder folder;
  const std::string options = model("old_example002") + " --size 60x50 --camera 65,-95,60,0,0,-2 ";
  require_success(run("render " + options + "-o " + (folder / "a.png") + " --stats " + (folder / "a.json")));
  require_success(run("compile " + options + "-o " + (folder / "p.csgt")));
  require_success(run("disasm " + (folder / "p.csgt") + " -o " + (folder / "p.txt")));
  for (const std::string program : {"p.csgt", "p.txt"}) {
    REQUIRE(run("run " + (folder / program) + " -o " + (folder / "b.png") + " --stats " + (folder / "b.json")).code ==
            0);
    CHECK(content(folder / "b.png") == content(folder / "a.png"));
    nlohmann::json a = json(folder / "a.json");
    nlohmann::json b = json(folder / "b.json");
    for (nlohmann::json* stats : {&a, &b}) {
      stats->erase("wall_seconds");
      stats->erase("configuration");
    }
    CHECK(a == b);
  }
}

TEST_CASE("wave records the requested window of clocks and writes a view for GTKWave") {
  const Folder folder;
  const std::string options = "wave " + model("old_example011") + " --size 16x16 --probe 8,8 --probe 0,15 ";
  require_success(run(options + "--window 50:80 -o " + (folder / "w.vcd")));
  const std::string wave = content(folder / "w.vcd");
  for (const std::string name :
       {"pixel_8_8", "pixel_0_15", "tree_bit", "carry", "enable", "Z1 [19:0]", "text", "purpose"}) {
    CHECK(wave.find(name) != std::string::npos);
  }
  // Clock n begins at (n + 1) periods of 100 ns; the last change is at the end of the window.
  const auto last = std::stoull(wave.substr(wave.rfind("\n#") + 2));
  CHECK(last > 80 * 100'000ULL);
  CHECK(last <= 82 * 100'000ULL);
  const std::string view = content(folder / "w.gtkw");
  CHECK(view.find("frame_buffer.pixel_8_8.Z1[19:0]") != std::string::npos);
  // Probed signals come first, so that they are visible without scrolling.
  CHECK(view.rfind("frame_buffer.pixel_") < view.find("frame_buffer.host."));
  CHECK(folder.files() == 3);
}

TEST_CASE("wave rejects an empty window or probe or a wrong name and leaves no file") {
  const Folder folder;
  const std::string options = "wave " + model("old_example011") + " --size 16x16 -o " + (folder / "w.vcd ");
  CHECK(run(options + "--probe 16,0").code == 2);
  CHECK(run(options + "--probe 1,1 --window 9:9").code == 2);
  CHECK(run(options + "--probe 1,1 --window 0:9 --at owner").code == 2);
  CHECK(run(options + "--window 0:9").code == 2);
  CHECK(run(options + "--probe 1,1 --window purpose:merg").err.find("did you mean merge?") != std::string::npos);
  CHECK(run(options + "--probe 1,1 --probe tree.x:5").err.find("levels 0 to 4") != std::string::npos);
  CHECK(run(options + "--probe 1,1 --window 10000000:10000001").code == 2);
  CHECK(run("wave " + model("old_example011") + " --probe 1,1 -o " + (folder / "w.txt")).code == 2);
  CHECK(folder.files() == 0);
}

TEST_CASE("strategy and colouring and pruning change counts but not pictures") {
  const Folder folder;
  const std::string draw = "render " + model("old_example002") + " --size 90x70 --memory-bits 100 ";
  require_success(run(draw + "-o " + (folder / "p.png")));
  for (const std::string options : {"--strategy list", "--strategy bits --stack-bits 3", "--strategy products",
                                    "--strategy parallel", "--strategy auto", "--colouring field", "--pruning none",
                                    "--pruning no-early-out", "--pruning no-space+no-hidden --threads 3"}) {
    CAPTURE(options);
    require_success(run(draw + options + " -o " + (folder / "q.png") + " --stats " + (folder / "s.json")));
    CHECK(content(folder / "q.png") == content(folder / "p.png"));
    const nlohmann::json stats = json(folder / "s.json");
    CHECK(stats["strategy_used"] != "auto");
    CHECK(stats["memory"]["tree_depth"] >= 2);
  }
}

TEST_CASE("a Program with early out compiles and runs on machines with a global OR") {
  const Folder folder;
  std::string text = content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml");
  const std::string present = "[global_or.present]\nvalue = 1";
  REQUIRE(text.find(present) != std::string::npos);
  text.replace(text.find(present) + present.size() - 1, 1, "0");
  write(folder / "deaf.toml", text);
  const std::string compile = "compile " + model("old_example002") + " --size 60x50 -o ";
  require_success(run(compile + (folder / "asks.csgt")));
  require_success(run(compile + (folder / "deaf.csgt") + " --pruning all --machine " + (folder / "deaf.toml")));
  require_success(run(compile + (folder / "mute.csgt") + " --pruning no-early-out"));
  CHECK(run("disasm " + (folder / "asks.csgt")).out.find("skip_if_none") != std::string::npos);
  CHECK(run("disasm " + (folder / "deaf.csgt")).out.find("skip_if_none") == std::string::npos);
  const auto without_machine = [&](const std::string& name) {
    const std::string printed = run("disasm " + (folder / name)).out;
    const std::size_t begin = printed.find(".machine");
    REQUIRE(begin != std::string::npos);
    return printed.substr(0, begin) + printed.substr(printed.find('\n', begin));
  };
  CHECK(without_machine("deaf.csgt") == without_machine("mute.csgt"));

  const std::string on_deaf = " --machine " + (folder / "deaf.toml") + " -o " + (folder / "p.png");
  require_success(run("run " + (folder / "deaf.csgt") + on_deaf));
  fs::remove(folder / "p.png");
  for (const char* level : {"functional", "cycle", "reference"}) {
    const Outcome refused = run("run " + (folder / "asks.csgt") + on_deaf + " --level " + level);
    CHECK(refused.code == 1);
    CHECK(refused.err.find("needs a global OR") != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "p.png"));
  }
}

TEST_CASE("colours of 12 bits differ by at most half a step from those of 24 bits") {
  const Folder folder;
  const std::string draw = "render " + model("old_example003") + " --size 40x30 ";
  require_success(run(draw + "-o " + (folder / "fine.ppm")));
  require_success(run(draw + "--colour-bits 12 -o " + (folder / "coarse.ppm")));
  const std::string fine = content(folder / "fine.ppm");
  const std::string coarse = content(folder / "coarse.ppm");
  REQUIRE(fine.size() == coarse.size());
  CHECK(fine != coarse);
  int worst = 0;
  for (std::size_t i = fine.size() - 3U * 40 * 30; i < fine.size(); ++i) {
    worst = std::max(worst, std::abs(static_cast<unsigned char>(fine[i]) - static_cast<unsigned char>(coarse[i])));
  }
  CHECK(worst <= 9);
}

TEST_CASE("converts a tolerance in pixels to model units that are finer for larger pictures") {
  const std::string draw = "render " + model("basics_csg") + " --size ";
  const Outcome coarse = run(draw + "64x64 --tolerance 0.5px");
  const Outcome fine = run(draw + "256x256 --tolerance 0.5px");
  CHECK(coarse.code == 0);
  CHECK(coarse.out.find("0.5 pixels at the nearest point of the model") != std::string::npos);
  CHECK(coarse.out.substr(0, 60) != fine.out.substr(0, 60));
  check_misuse("render x.csg --tolerance 3mm", "is not of the form 0.1, or 0.5px");
}

TEST_CASE("every command has help with an example") {
  for (const std::string command : {"render", "compile", "run", "disasm", "debug", "diff", "wave", "accuracy", "advise",
                                    "sweep", "levels", "manual"}) {
    const Outcome outcome = run(command + " --help");
    CAPTURE(command);
    CHECK(outcome.code == 0);
    CHECK(outcome.out.find("Example:\n  csgsim " + command) != std::string::npos);
  }
}

TEST_CASE("the manual lists the machines briefly and gives the source of each parameter") {
  const Outcome list = require_success(run("manual machines"));
  CHECK(std::ranges::count(list.out, '\n') < 14);
  for (const char* const name : {"pixel-planes-4 ", "scan-line ", "multi-processor "})
    CHECK(list.out.find(name) != std::string::npos);
  CHECK(run("manual").out.find("instructions") != std::string::npos);
  check_misuse("manual instruction", "did you mean instructions?");
  check_misuse("manual scenes pixel-planes-4", "NAME: csgsim manual scenes accepts no name");
  const Outcome outcome = require_success(run("manual machines pixel-planes-4"));
  CHECK(outcome.out.find("alu.bits") != std::string::npos);
  CHECK(outcome.out.find("published") != std::string::npos);
  CHECK(outcome.out.find("assumed") != std::string::npos);
}

TEST_CASE("the documented instruction set equals the printed manual page") {
  CHECK(run("manual instructions").out == content(std::string(CSGSIM_SOURCE_DIR) + "/docs/instruction-set.md"));
}

TEST_CASE("the documentation of scene files equals the printed manual page") {
  CHECK(run("manual scenes").out == content(std::string(CSGSIM_SOURCE_DIR) + "/docs/scene-files.md"));
}

TEST_CASE("wrong usage ends with exit code 2 and one line of error") {
  check_misuse("", "name a command");
  check_misuse("rendr x.csg", "rendr");
  check_misuse("render", "MODEL");
  check_misuse("render m.csg --colour", "--colour");
  check_misuse("render m.csg --level gate", "gate");
  check_misuse("render m.csg --size 12", "WxH");
  check_misuse("render m.csg --size 12x-4", "WxH");
  check_misuse("render " + model("old_example003") + " --camera 1,2,3", "ex,ey,ez,cx,cy,cz");
  check_misuse("render m.csg --z-bits many", "--z-bits");
  check_misuse("compile m.csg", "--output");
}

TEST_CASE("rejects missing and empty files and directories and syntax errors in one line") {
  const Folder folder;
  check_rejected(folder / "none.csg", "none.csg");
  fs::create_directory(folder / "dir.csg");
  check_rejected(folder / "dir.csg", "dir.csg");
  check_text_rejected("", "m.csg");
  check_text_rejected("cube(size = [1, 2, 3]", "m.csg:1:");
  check_text_rejected("union() {\n cube(size = 1);\n", "m.csg:");
  check_text_rejected("sphere(r = 1e999);", "m.csg:1:");
}

TEST_CASE("the error for a node that cannot become half-spaces states its place") {
  check_text_rejected("union() {\n  roof(method = \"voronoi\") { square(size = 2); }\n}", "m.csg:2:3: roof()");
  check_text_rejected("union() {\n  fill() { square(size = 2); }\n}", "m.csg:2:3: fill()");
}

TEST_CASE("rejects a hundred megabytes of brackets quickly") {
  const Folder folder;
  for (const std::string bracket : {"{", "(", "[", "group(){", "cube([", "}"}) {
    std::string text;
    const auto bytes = csgsim::testing::cases<std::size_t>(100'000'000, 5'000'000);
    while (text.size() < bytes) text += bracket;
    write(folder / "m.csg", text);
    check_rejected(folder / "m.csg", "m.csg:");
  }
}

TEST_CASE("an error states what a machine lacks to hold the picture") {
  check_rejected(model("old_example002") + " --memory-bits 40", "--memory-bits");
  check_misuse("render " + model("old_example002") + " --z-bits 31",
               "--z-bits: '31' is not a whole number from 4 to 30");
  check_misuse("render " + model("old_example002") + " --machine pixel-plane-4", "pixel-planes-4");
}

TEST_CASE("rejects a broken Program file") {
  const Folder folder;
  write(folder / "p.csgt", "CSGT but not really");
  CHECK(run("run " + (folder / "p.csgt")).code == 1);
  CHECK(run("disasm " + (folder / "p.csgt")).code == 1);
  CHECK(run("run " + (folder / "none.csgt")).code == 1);
}

TEST_CASE("rendering an empty model gives an empty picture") {
  const Folder folder;
  write(folder / "m.csg", "cube(size = 0);");
  require_success(run("render " + (folder / "m.csg") + " --size 16x16 -o " + (folder / "p.png")));
}

TEST_CASE("every level rejects a Program that overflows with the same count") {
  const Folder folder;
  std::string text = run("disasm " + std::string(CSGSIM_SOURCE_DIR) + "/traces/old_example002.csgt").out;
  const std::string wide = "(w34 >> 12)";
  REQUIRE(text.find(wide) != std::string::npos);
  for (std::size_t at = text.find(wide); at != std::string::npos; at = text.find(wide, at))
    text.replace(at, wide.size(), "(w33 >> 12)");
  write(folder / "p.txt", text);
  const std::string words = "run " + (folder / "p.txt") + " -o " + (folder / "p.png") + " --level ";
  const Outcome expected = run(words + "reference");
  fails(expected, 1, {"overflows"});
  for (const std::string level : {"functional", "cycle"}) {
    const Outcome outcome = run(words + level);
    CHECK(outcome.code == 1);
    CHECK(outcome.err == expected.err);
  }
  const Outcome wave = run("wave " + (folder / "p.txt") + " --probe 1,1 -o " + (folder / "w.vcd"));
  CHECK(wave.code == 1);
  CHECK(wave.err == expected.err);
  CHECK(folder.files() == 1);
}

TEST_CASE("csgsim distinguishes models and Programs by their file names") {
  const Folder folder;
  const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt";
  CHECK(run("render " + program).err.find("use csgsim run") != std::string::npos);
  CHECK(run("run " + model("old_example011")).err.find("csgsim render draws it") != std::string::npos);
  check_misuse("wave " + program + " --probe 1,1 --size 16x16 -o " + (folder / "w.vcd"), "--size");
  check_misuse("wave " + program + " --probe 1,1 --view-all -o " + (folder / "w.vcd"), "--view-all");
  fs::copy_file(model("old_example011"), folder / "M.CSG");
  require_success(run("wave " + (folder / "M.CSG") + " --size 16x16 --probe 1,1 -o " + (folder / "w.vcd")));
}

TEST_CASE("rejects a folder as machine file and a clock that is too fast") {
  const Folder folder;
  fs::create_directory(folder / "m.toml");
  CHECK(run("manual machines " + (folder / "m.toml")).code == 1);
  std::string text = content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml");
  const std::size_t at = text.find("10_000_000");
  if (at != std::string::npos) text.replace(at, 10, "10_000_000_001");
  write(folder / "fast.toml", text);
  CHECK(run("manual machines " + (folder / "fast.toml")).code == (at == std::string::npos ? 0 : 1));
}

TEST_CASE("an error suggests nothing for a word that resembles no known one") {
  check_misuse("rendr x.csg", "did you mean render?");
  CHECK(run("xyzzy").err.find("did you mean") == std::string::npos);
  CHECK(run("render m.csg --xylophone").err.find("did you mean") == std::string::npos);
}

TEST_CASE("the GTKWave view and the waveform give a field the same name") {
  const Folder folder;
  std::string text = run("disasm " + std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt").out;
  for (std::size_t at = text.find("Z1"); at != std::string::npos; at = text.find("Z1", at))
    text.replace(at, 2, "\"Z-1\"");
  write(folder / "p.txt", text);
  require_success(run("wave " + (folder / "p.txt") + " --probe 1,1 --window 0:9 -o " + (folder / "w.vcd")));
  CHECK(content(folder / "w.vcd").find("Z_1") != std::string::npos);
  CHECK(content(folder / "w.gtkw").find(".Z_1[") != std::string::npos);
}
