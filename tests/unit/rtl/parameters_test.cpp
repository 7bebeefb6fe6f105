#include "sim/rtl/parameters.h"

#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "sim/rtl/board.h"
#include "sim/rtl/design.h"
#include "sim/rtl/program_memory.h"
#include "sim/rtl/template.h"
#include "tests/support/test.h"

using namespace csgsim;

// Tests of Verilog parameters at the limits of figures.

namespace {

using Values = std::map<std::string, std::uint32_t>;

Values values_of(const machines::Machine& machine, const isa::Program* program = nullptr) {
  Values values;
  for (const rtl::Parameter& parameter : rtl::verilog_parameters(machine, program))
    values[std::string(parameter.name)] = parameter.value;
  return values;
}

machines::Machine eight_by_eight(std::vector<std::string> changes = {}) {
  changes.insert(changes.begin(), {"array.width=8", "array.height=8"});
  return kinds::load("pixel-planes-4", changes);
}

/// A Program with `colour_bits` bits of colour and a segment for each of these instructions.
isa::Program showing(unsigned colour_bits, const std::vector<isa::Opcode>& opcodes) {
  isa::Program program;
  program.shape = {8, 8, 72};
  program.colour = {0, static_cast<std::uint16_t>(colour_bits)};
  for (const isa::Opcode opcode : opcodes) {
    isa::Instruction instruction{.opcode = opcode};
    if (opcode == isa::Opcode::root) instruction.fields[0] = {30, 5};
    program.segments.push_back({.region = {0, 0, 8, 8}, .instructions = {instruction}});
  }
  return program;
}

std::string video_of(unsigned colour_bits, unsigned scan_pixels) {
  std::vector<rtl::Filling> fillings;
  rtl::add_board(fillings, {.colour_bits = colour_bits, .scan_pixels = scan_pixels, .has_line = false});
  return rtl::fill_template("@CHANNEL_BITS@:\n@BOARD_VIDEO@", fillings);
}

const std::string& text_of(const std::vector<rtl::DesignFile>& files, std::string_view path) {
  const auto found = std::ranges::find(files, path, &rtl::DesignFile::path);
  REQUIRE(found != files.end());
  return found->content;
}

}  // namespace

TEST_CASE("Verilog parameters have the values of the machine's parameters") {
  CHECK(values_of(kinds::load("pixel-planes-4")) == Values{{"WIDTH", 512},
                                                           {"HEIGHT", 512},
                                                           {"MEMORY_BITS", 72},
                                                           {"MEMORY_READS", 1},
                                                           {"ALU_BITS", 1},
                                                           {"DEGREE", 1},
                                                           {"ROOTS", 0},
                                                           {"LINK", 32},
                                                           {"FIFO_DEPTH", 16},
                                                           {"CLEAR_CLOCKS", 72},
                                                           {"HAS_OR", 1},
                                                           {"FAN_IN", 64},
                                                           {"SCAN_PIXELS", 2},
                                                           {"SCAN_SHARED", 1},
                                                           {"BUFFERS", 1},
                                                           {"COLOUR_BITS", 24},
                                                           {"CHIP", 64}});
  CHECK(values_of(kinds::load("pixel-planes-4", {"array.width=7", "array.height=5", "array.memory_bits=96",
                                                 "memory.reads=2", "alu.bits=4", "evaluator.degree=2", "link.width=10",
                                                 "link.fifo_depth=3", "memory.clear_clocks=9", "global_or.present=0",
                                                 "global_or.fan_in=5", "scan_out.pixels=3", "scan_out.port=own",
                                                 "scan_out.buffers=2"})) == Values{{"WIDTH", 7},
                                                                                   {"HEIGHT", 5},
                                                                                   {"MEMORY_BITS", 96},
                                                                                   {"MEMORY_READS", 2},
                                                                                   {"ALU_BITS", 4},
                                                                                   {"DEGREE", 2},
                                                                                   {"ROOTS", 1},
                                                                                   {"LINK", 10},
                                                                                   {"FIFO_DEPTH", 3},
                                                                                   {"CLEAR_CLOCKS", 9},
                                                                                   {"HAS_OR", 0},
                                                                                   {"FAN_IN", 5},
                                                                                   {"SCAN_PIXELS", 3},
                                                                                   {"SCAN_SHARED", 0},
                                                                                   {"BUFFERS", 2},
                                                                                   {"COLOUR_BITS", 24},
                                                                                   {"CHIP", 35}});
}

TEST_CASE("a scan-out in a design is limited to the width of the array") {
  CHECK(values_of(eight_by_eight({"scan_out.pixels=7"}))["SCAN_PIXELS"] == 7);
  CHECK(values_of(eight_by_eight({"scan_out.pixels=8"}))["SCAN_PIXELS"] == 8);
  CHECK(values_of(eight_by_eight({"scan_out.pixels=9"}))["SCAN_PIXELS"] == 8);
  CHECK(values_of(eight_by_eight({"scan_out.pixels=512"}))["SCAN_PIXELS"] == 8);
  // An array higher than wide.
  CHECK(values_of(kinds::load("pixel-planes-4+array.width=3+array.height=9+scan_out.pixels=5"))["SCAN_PIXELS"] == 3);
}

TEST_CASE("the Verilog parameter CHIP is the number of pixels but at most 64") {
  const auto chip = [](const std::string& size) { return values_of(kinds::load("pixel-planes-4" + size))["CHIP"]; };
  CHECK(chip("+array.width=9+array.height=7") == 63);
  CHECK(chip("+array.width=8+array.height=8") == 64);
  CHECK(chip("+array.width=13+array.height=5") == 64);
  CHECK(chip("+array.width=1+array.height=1") == 1);
}

TEST_CASE("the Verilog parameter CLEAR_CLOCKS is at least 1") {
  CHECK(values_of(eight_by_eight({"memory.clear_clocks=ideal"}))["CLEAR_CLOCKS"] == 1);
  CHECK(values_of(eight_by_eight({"memory.clear_clocks=1"}))["CLEAR_CLOCKS"] == 1);
  CHECK(values_of(eight_by_eight({"memory.clear_clocks=2"}))["CLEAR_CLOCKS"] == 2);
}

TEST_CASE("pixels have the root flag at degree 2 or if a segment takes a root") {
  using isa::Opcode;
  const machines::Machine machine = eight_by_eight();
  const auto roots = [&](const std::vector<Opcode>& opcodes) {
    const isa::Program program = showing(24, opcodes);
    return values_of(machine, &program)["ROOTS"];
  };
  CHECK(roots({Opcode::enable_all, Opcode::enable_invert}) == 0);
  CHECK(roots({Opcode::root, Opcode::enable_all}) == 1);
  CHECK(roots({Opcode::enable_all, Opcode::root}) == 1);
  CHECK(values_of(machine)["ROOTS"] == 0);
  CHECK(values_of(eight_by_eight({"evaluator.degree=2"}))["ROOTS"] == 1);
  const isa::Program without = showing(24, {Opcode::enable_all});
  CHECK(values_of(eight_by_eight({"evaluator.degree=2"}), &without)["ROOTS"] == 1);
}

TEST_CASE("the Verilog's COLOUR_BITS is the Program's width or 24 with a serial line") {
  for (const unsigned bits : {3U, 4U, 7U, 10U, 24U}) {
    const isa::Program program = showing(bits, {isa::Opcode::enable_all});
    CHECK(values_of(eight_by_eight(), &program)["COLOUR_BITS"] == bits);
  }
  CHECK(values_of(eight_by_eight())["COLOUR_BITS"] == 24);
}

TEST_CASE("trees of several bits or fewer registers are rejected by the parameter's name") {
  const auto refusal = [](const std::string& changes) {
    return testing::error_of([&] { rtl::verilog_parameters(kinds::load("pixel-planes-4" + changes)); });
  };
  CHECK(refusal("+alu.bits=3+evaluator.bits=3")
            .ends_with("evaluator.bits is 3, but the Verilog supports only 1; add --set evaluator.bits=1"));
  CHECK(refusal("+evaluator.register_levels=3")
            .ends_with("evaluator.register_levels is 3, but the Verilog supports only 1; add --set "
                       "evaluator.register_levels=1"));
  CHECK(refusal("+alu.bits=3") == "");
}

TEST_CASE("a board shows 3 to 24 bits with zeros below narrower channels") {
  CHECK(video_of(3, 1) == "1:\n  assign video[2:0] = {colours[2:2], colours[1:1], colours[0:0]};\n");
  // Green has the most bits.
  CHECK(video_of(4, 1) == "2:\n  assign video[5:0] = {colours[3:3], 1'd0, colours[2:1], colours[0:0], 1'd0};\n");
  CHECK(video_of(5, 1) == "2:\n  assign video[5:0] = {colours[4:3], colours[2:1], colours[0:0], 1'd0};\n");
  CHECK(video_of(7, 1) == "3:\n  assign video[8:0] = {colours[6:5], 1'd0, colours[4:2], colours[1:0], 1'd0};\n");
  CHECK(video_of(10, 1) == "4:\n  assign video[11:0] = {colours[9:7], 1'd0, colours[6:3], colours[2:0], 1'd0};\n");
  CHECK(video_of(24, 1) == "4:\n  assign video[11:0] = {colours[23:20], colours[15:12], colours[7:4]};\n");
  CHECK(video_of(4, 2) ==
        "2:\n  assign video[5:0] = {colours[3:3], 1'd0, colours[2:1], colours[0:0], 1'd0};\n"
        "  assign video[11:6] = {colours[7:7], 1'd0, colours[6:5], colours[4:4], 1'd0};\n");
}

TEST_CASE("wires of a design have the widths of its scan-out and colour") {
  const isa::Program program = showing(7, {isa::Opcode::enable_all});
  const auto files =
      rtl::design_files(eight_by_eight({"scan_out.pixels=64", "link.latency=3", "link.word_clocks=2"}), &program);
  const std::string& testbench = text_of(files, "testbench.v");
  CHECK(testbench.find("localparam WIDTH = 8;") != std::string::npos);
  CHECK(testbench.find("localparam HEIGHT = 8;") != std::string::npos);
  CHECK(testbench.find("localparam SCAN_PIXELS = 8;") != std::string::npos);
  CHECK(testbench.find("localparam VIDEO_BITS = 7;") != std::string::npos);
  CHECK(testbench.find("localparam RED = 2, GREEN = 3, BLUE = 2;") != std::string::npos);
  const std::string& system = text_of(files, "system.v");
  CHECK(system.find("output wire [56-1:0] video,") != std::string::npos);
  CHECK(system.find("    .SCAN_PIXELS(8),        // scan_out.pixels\n") != std::string::npos);
  CHECK(system.find("    .COLOUR_BITS(7),\n") != std::string::npos);
  CHECK(system.find("    .CHIP(64)\n") != std::string::npos);
  CHECK(system.find(".LATENCY(3),") != std::string::npos);
  CHECK(system.find(".WORD_CLOCKS(2),") != std::string::npos);
  CHECK(text_of(files, "board.v").find("output wire [3*3*8-1:0] video") != std::string::npos);
}

TEST_CASE("a Program's memory has one line per word and instruction with minimal digits") {
  // A start and an instruction of its segment, and the end of the frame.
  const isa::Program program = showing(24, {isa::Opcode::enable_all});
  const rtl::ProgramMemory memory = rtl::program_memory(program, 256);
  CHECK(memory.begin_count == 2);
  CHECK(memory.word_count == static_cast<std::uint64_t>(std::ranges::count(memory.words, '\n')));
  CHECK(memory.words.find('\n') == 64);
  CHECK(memory.begins.starts_with("0\n"));
  // The Program has more than 15 words of one bit: their numbers have two digits.
  const rtl::ProgramMemory narrow = rtl::program_memory(program, 1);
  CHECK(narrow.words.find('\n') == 1);
  CHECK(narrow.word_count > 15);
  CHECK(narrow.word_count < 256);
  CHECK(narrow.begins.starts_with("00\n"));
}
