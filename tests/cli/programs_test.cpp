#include "hw/isa/binary.h"
#include "hw/isa/program_file.h"
#include "hw/isa/text.h"
#include "places.h"
#include "tests/cli/cli.h"
#include "tests/support/bare_text.h"

using namespace csgsim;
using namespace csgsim::testing::cli;

namespace {

std::string trace(const std::string& name) { return std::string(CSGSIM_SOURCE_DIR) + "/traces/" + name + ".csgt"; }

std::string compiled(const Folder& folder, const std::string& name, const std::string& options) {
  const std::string program = folder / name;
  require_success(run("compile " + testing::cli::model("old_example002") + " --view-all --size 40x30 " + options +
                      " -o " + program));
  return program;
}

nlohmann::json stats_of(const Folder& folder, const std::string& words) {
  const Outcome outcome = run("run " + words + " --stats " + (folder / "stats.json"));
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  return json(folder / "stats.json");
}

/// Checks that removing facts and comments from a Program changes neither its clocks nor its picture.
void check_same_at_cycle_level(const std::string& path) {
  CAPTURE(path);
  const Folder folder;
  write(folder / "bare.csgt", testing::bare_text(isa::load_program(path)));
  const nlohmann::json with = stats_of(folder, path + " --level cycle -o " + (folder / "with.png"));
  const nlohmann::json without =
      stats_of(folder, (folder / "bare.csgt") + " --level cycle -o " + (folder / "without.png"));
  for (const char* key : {"clocks", "shown_clocks", "interval_clocks", "instructions", "pixel_operations", "account"}) {
    CAPTURE(key);
    REQUIRE(with.contains(key));
    CHECK(with[key] == without[key]);
  }
  CHECK(content(folder / "with.png") == content(folder / "without.png"));
}

}  // namespace

TEST_CASE("stepped and computed trees give the picture and counts of a golden Program") {
  const Folder folder;
  for (const std::string name : {"thesis_fig_2_3", "thesis_fig_2_3_squares"}) {
    CAPTURE(name);
    const std::string words = trace(name) + " --level cycle -o " + (folder / "p.png");
    nlohmann::json worked_out = stats_of(folder, words);
    const std::string picture = content(folder / "p.png");
    nlohmann::json stepped = stats_of(folder, words + " --evaluator stepped");
    CHECK(content(folder / "p.png") == picture);
    for (nlohmann::json* const stats : {&worked_out, &stepped}) {
      stats->erase("wall_seconds");
      stats->erase("configuration");
    }
    CHECK(stepped == worked_out);
  }
}

TEST_CASE("rejects stepped trees at other levels and on machines without trees") {
  check_misuse("run " + trace("thesis_fig_2_3") + " --evaluator stepped", "add --level cycle");
  fails(run("run " + trace("thesis_fig_2_3_nodes") + " --level cycle --evaluator stepped"), 1,
        {"a machine of kind multi-processor has no multiplier trees that can be stepped"});
}

TEST_CASE("facts and comments of a golden Program change nothing at the cycle level") {
  for (const char* name : {"thesis_fig_2_3", "carburettor", "terrain_vehicle", "old_example002", "old_example002_lines",
                           "thesis_fig_2_3_squares", "thesis_fig_2_3_nodes"})
    check_same_at_cycle_level(trace(name));
}

TEST_CASE("run draws a Program on its recorded machine in the clocks of render") {
  const Folder folder;
  for (const std::string machine : {"scan-line", "pixel-square", "multi-processor", "pixel-powers",
                                    "pixel-planes-4+alu.bits=4+array.memory_bits=96"}) {
    CAPTURE(machine);
    const std::string program = compiled(folder, "p.csgt", "--machine " + machine);
    require_success(run("render " + testing::cli::model("old_example002") + " --view-all --size 40x30 --machine " +
                        machine + " -o " + (folder / "render.png") + " --stats " + (folder / "render.json")));
    const nlohmann::json rendered = json(folder / "render.json");
    const nlohmann::json ran = stats_of(folder, program + " -o " + (folder / "run.png"));
    CHECK(ran["machine"] == rendered["machine"]);
    CHECK(ran["machine"]["name"] == machine);
    CHECK(ran["clocks"] == rendered["clocks"]);
    CHECK(ran["configuration"]["machine"] == rendered["configuration"]["machine"]);
    CHECK(content(folder / "run.png") == content(folder / "render.png"));
  }
}

TEST_CASE("a Program compiled for a machine file runs without the file") {
  const Folder folder;
  std::string text = content(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/scan-line.toml");
  text.replace(text.find("name = \"scan-line\""), 18, "name = \"my lines\"");
  text.replace(text.find("value = 10_000_000"), 18, "value = 12_000_000");
  write(folder / "mine.toml", text);
  const std::string program = compiled(folder, "p.csgt", "--machine " + (folder / "mine.toml"));
  const nlohmann::json named = stats_of(folder, program + " --machine " + (folder / "mine.toml"));
  fs::remove(folder / "mine.toml");
  const nlohmann::json ran = stats_of(folder, program);
  CHECK(ran["machine"]["name"] == "my lines");
  CHECK(ran["machine"] == named["machine"]);
  CHECK(ran["clocks"] == named["clocks"]);
}

TEST_CASE("rejects a Program on another kind or smaller machine and names the differences") {
  const Folder folder;
  const std::string lines = compiled(folder, "lines.csgt", "--machine scan-line");
  const std::string output = " -o " + (folder / "out.png");
  const auto refused = [&](const std::string& words, const std::string& text) {
    const Outcome outcome = run(words);
    CAPTURE(words);
    fails(outcome, 1, {text});
  };
  const std::string other = "was compiled for scan-line, of kind scan-line, and pixel-planes-4 is of kind frame-buffer";
  refused("run " + lines + " --machine pixel-planes-4" + output, other);
  refused("explain " + lines + " --machine pixel-planes-4 --pixel 3,3", other);
  refused("wave " + lines + " --machine pixel-planes-4 --pixel 3,3 -o " + (folder / "out.vcd"), other);
  refused("debug " + lines + " --machine pixel-planes-4 -x " + lines, other);
  refused("diff " + lines + " --machine-b pixel-planes-4", other);
  const std::string wide = compiled(folder, "wide.csgt", "--machine pixel-planes-4 --memory-bits 96");
  CHECK(run("run " + wide + output).err.empty());
  CHECK(run("run " + wide + " --machine pixel-planes-4" + output).err.empty());
  refused("run " + wide + " --machine pixel-planes-4+alu.bits=4" + output,
          "needs 96 memory bits per pixel, and pixel-planes-4+alu.bits=4 has 72");
  const Outcome warned =
      require_success(run("run " + wide + " --machine pixel-planes-4+alu.bits=4+array.memory_bits=100" + output));
  CHECK(is_one_line(warned.err));
  CHECK(warned.err.find("was compiled for pixel-planes-4; ") != std::string::npos);
  CHECK(warned.err.find("alu.bits 4 instead of 1") != std::string::npos);
  CHECK(warned.err.find("array.memory_bits 100 instead of 72") != std::string::npos);
}

TEST_CASE("a warning names the machine that is assumed for a Program without one") {
  const Folder folder;
  isa::Program program = isa::load_program(trace("old_example002"));
  program.machine = {};
  isa::save_program(program, folder / "p.csgt", isa::ProgramForm::binary);
  const std::string output = " -o " + (folder / "out.png");
  const Outcome assumed = require_success(run("run " + (folder / "p.csgt") + output));
  CHECK(is_one_line(assumed.err));
  CHECK(assumed.err.find(
            "warning: the Program does not name the machine it was compiled for; pixel-planes-4 is assumed;") !=
        std::string::npos);
  CHECK(run("run " + (folder / "p.csgt") + " --machine pixel-planes-4" + output).err.empty());
  program.shape.memory_bits = 96;
  isa::save_program(program, folder / "p.csgt", isa::ProgramForm::binary);
  CHECK(run("run " + (folder / "p.csgt") + output).err.find("with 96 memory bits per pixel instead of 72") !=
        std::string::npos);
  CHECK(run("run " + (folder / "p.csgt") + " --machine pixel-planes-4" + output).code == 1);
  program.machine = {"no-such-machine", "", {}};
  isa::save_program(program, folder / "p.csgt", isa::ProgramForm::binary);
  fails(run("run " + (folder / "p.csgt") + output), 1, {"'no-such-machine'"});
}

TEST_CASE("disasm --row-commands lists row commands of memories and rejects other machines") {
  const Folder folder;
  const std::string rows = compiled(folder, "rows.csgt", "--machine simdram-ddr4");
  const Outcome text = require_success(run("disasm " + rows + " --row-commands"));
  CHECK(text.out.starts_with("# simdram-ddr4: 40 x 30 pixels"));
  CHECK(text.out.find("\nAAP ") != std::string::npos);
  require_success(run("disasm " + rows + " --row-commands -o " + (folder / "rows.txt")));
  CHECK(content(folder / "rows.txt") == text.out);
  const Outcome other = run("disasm " + compiled(folder, "other.csgt", "") + " --row-commands");
  CHECK(other.code == 1);
  CHECK(other.out.empty());
  CHECK(other.err.find("pixel-planes-4, which has no row commands") != std::string::npos);
  write(folder / "bad.csgt", "no Program\n");
  const Outcome bad = run("disasm " + (folder / "bad.csgt") + " --row-commands");
  CHECK(bad.code == 1);
  CHECK(bad.out.empty());
  CHECK(bad.err.find("bad.csgt:1:1") != std::string::npos);
}

TEST_CASE("rows writes the row commands of a run, to a file or to standard output") {
  const Folder folder;
  const std::string options = "rows " + model("old_example011") + " --machine simdram-ddr4 --size 8x6";
  const Outcome written = require_success(run(options + " -o " + (folder / "trace.rows")));
  CHECK(written.out.find(" row commands in ") != std::string::npos);
  CHECK(written.out.find("cannot express") == std::string::npos);
  const std::string trace = content(folder / "trace.rows");
  CHECK(trace.starts_with("csgsim-rows 1\nmachine simdram-ddr4\n"));
  const Outcome streamed = require_success(run(options + " -o -"));
  CHECK(streamed.out == trace);
  CHECK(streamed.err.find(" row commands in ") != std::string::npos);
  CHECK(run(options + " -q -o " + (folder / "again.rows")).out == "");
  CHECK(content(folder / "again.rows") == trace);
  const std::string program = compiled(folder, "p.csgt", "--machine simdram-ddr4");
  const Outcome replaced = require_success(run("rows " + program + " --form drampower -o " + (folder / "trace.csv")));
  CHECK(replaced.out.find("drampower cannot express") != std::string::npos);
  CHECK(replaced.out.find("AAP; it contains ACT, ACT and PRE instead\n") != std::string::npos);
}

TEST_CASE("rows rejects machines without row commands and unknown forms") {
  const Folder folder;
  const std::string out = " -o " + (folder / "trace.rows");
  fails(run("rows " + model("old_example011") + " --size 8x6" + out), 1,
        {"pixel-planes-4 has no row commands; choose a machine of kind bit-serial-memory, as --machine simdram-ddr4"});
  fails(run("rows " + compiled(folder, "p.csgt", "") + out), 1, {"pixel-planes-4 has no row commands"});
  check_misuse("rows " + model("old_example011") + " --form drampowr" + out, "did you mean drampower?");
  check_misuse("rows " + (folder / "p.csgt") + " --size 8x6" + out, "--size");
  fails(
      run("rows " + model("old_example011") + " --size 8x6 --machine simdram-ddr4+chips.count=4 --form dramsim3" + out),
      1, {"addresses of dramsim3 are those of eight chips"});
  CHECK_FALSE(fs::exists(folder / "trace.rows"));
  const std::string program = compiled(folder, "q.csgt", "--machine simdram-ddr4");
  fails(run("rows " + program + " -o " + program), 2, {"the same file as the input"});
}

TEST_CASE("rows replaces the gates of a memory by those of a command set") {
  const Folder folder;
  const std::string options = "rows " + model("old_example011") + " --size 8x6 -o " + (folder / "trace.rows");
  const std::string set =
      " --command-set " + std::string(CSGSIM_SOURCE_DIR) + "/hw/bit_serial_memory/command_sets/nand.toml";
  const Outcome usual = require_success(run(options + " --machine digital-bit-serial-ddr4"));
  const Outcome replaced = require_success(run(options + " --machine digital-bit-serial-ddr4" + set));
  CHECK(replaced.out != usual.out);
  const std::string trace = content(folder / "trace.rows");
  CHECK(trace.find("\ngate NAND 1110 4 23\n") != std::string::npos);
  CHECK(trace.find(" LOGIC T1 = NAND ") != std::string::npos);
  CHECK(trace.find(" XOR ") == std::string::npos);
  fails(run(options + " --machine simdram-ddr4" + set), 1,
        {"simdram-ddr4 has no gates that a command set could replace"});
  write(folder / "set.toml", "name = \"t\"\ndescription = 1\n");
  fails(run(options + " --machine digital-bit-serial-ddr4 --command-set " + (folder / "set.toml")), 1,
        {"set.toml:2:15: 'description' is an integer; make it a string"});
}
