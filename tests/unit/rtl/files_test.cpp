#include <rapidcheck.h>

#include <initializer_list>

#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "sim/rtl/board.h"
#include "sim/rtl/design.h"
#include "sim/rtl/parameters.h"
#include "sim/rtl/program_memory.h"
#include "sim/rtl/template.h"
#include "sim/rtl/templates.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;

// Tests of the contents of each file of a design.

namespace {

using Files = std::vector<rtl::DesignFile>;

machines::Machine small_machine() { return kinds::load("pixel-planes-4+array.width=8+array.height=8"); }

/// A Program that enables all pixels and shows `colour_bits` bits of colour.
isa::Program enabling(std::uint16_t colour_bits) {
  isa::Program program;
  program.shape = {8, 8, 72};
  program.colour = {0, colour_bits};
  program.segments.push_back({.region = {0, 0, 8, 8}, .instructions = {{.opcode = isa::Opcode::enable_all}}});
  return program;
}

std::string find_file(const Files& files, std::string_view path) {
  const auto found = std::ranges::find(files, path, &rtl::DesignFile::path);
  REQUIRE(found != files.end());
  return found->content;
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// Paths of the files in addition to the modules, in order.
std::vector<std::string> written_paths(const Files& files) {
  std::vector<std::string> paths;
  for (const rtl::DesignFile& file : files)
    if (!file.path.starts_with("rtl/")) paths.push_back(file.path);
  return paths;
}

/// A machine of 8 x 8 pixels with 24 bits of colour: one line per parameter, followed from column 29 on by the figure
/// that it comes from.
constexpr std::string_view instance_parameters = R"(  pixel_planes #(
    .WIDTH(8),              // array.width
    .HEIGHT(8),             // array.height
    .MEMORY_BITS(72),       // array.memory_bits
    .MEMORY_READS(1),       // memory.reads
    .ALU_BITS(1),           // alu.bits
    .DEGREE(1),             // evaluator.degree
    .ROOTS(0),
    .LINK(32),              // link.width
    .FIFO_DEPTH(16),        // link.fifo_depth
    .CLEAR_CLOCKS(72),      // memory.clear_clocks
    .HAS_OR(1),             // global_or.present
    .FAN_IN(64),            // global_or.fan_in
    .SCAN_PIXELS(2),        // scan_out.pixels
    .SCAN_SHARED(1),        // scan_out.port
    .BUFFERS(1),            // scan_out.buffers
    .COLOUR_BITS(24),
    .CHIP(64)
  ) machine (
)";

}  // namespace

TEST_CASE("a design has all modules of hw/rtl and more files with a Program than without") {
  const isa::Program program = enabling(24);
  const Files drawn = rtl::design_files(small_machine(), &program);
  const Files bare = rtl::design_files(small_machine(), nullptr);
  CHECK(written_paths(drawn) == std::vector<std::string>{"program.hex", "begins.hex", "system.v", "board.v", "hx8k.pcf",
                                                         "up5k.pcf", "Makefile", "README.md", "testbench.v", "png.py",
                                                         "beside.py"});
  CHECK(written_paths(bare) ==
        std::vector<std::string>{"system.v", "board.v", "hx8k.pcf", "up5k.pcf", "Makefile", "README.md"});
  for (const Files& files : {drawn, bare}) {
    CHECK(static_cast<std::size_t>(std::ranges::count_if(files, [](const rtl::DesignFile& file) {
            return file.path.starts_with("rtl/");
          })) == rtl::verilog_files().size());
    for (const rtl::EmbeddedFile& file : rtl::verilog_files())
      CHECK(find_file(files, "rtl/" + std::string(file.name)) == file.text);
    CHECK(has(find_file(files, "rtl/pixel_planes.v"), "module pixel_planes"));
  }
}

TEST_CASE("a design's machine has one line per parameter with its figure") {
  const isa::Program program = enabling(24);
  for (const isa::Program* const shown : std::initializer_list<const isa::Program*>{&program, nullptr}) {
    const std::string system = find_file(rtl::design_files(small_machine(), shown), "system.v");
    CHECK(has(system, instance_parameters));
    CHECK(has(system, "output wire [48-1:0] video,"));  // two pixels of 24 bits
  }
}

TEST_CASE("a Program's memory in a design has the hand-calculated words") {
  // Words of 32 bits: SegmentStart, 61, with width 8 from bit 38 and height 8 from bit 54 on, 70 bits; enable_all, 0;
  // FrameEnd, 63, with base 0 from bit 6 and width 24 from bit 18 on.
  const isa::Program program = enabling(24);
  const Files files = rtl::design_files(small_machine(), &program);
  CHECK(find_file(files, "program.hex") == "0000003d\n02000200\n00000000\n00000000\n0060003f\n");
  // The first instruction starts after the frame command; its successor starts when it has been taken.
  CHECK(find_file(files, "begins.hex") == "0\n4\n");
  CHECK(has(find_file(files, "system.v"), ".LINK(32), .WORDS(5), .INSTRUCTIONS(1),"));
}

TEST_CASE("instruction starts have the fewest digits that hold the number of words") {
  const isa::ArrayShape shape{.width = 16, .height = 16, .memory_bits = 72};
  CHECK(rc::check([&] {
    const isa::Program program = *test::arbitrary_program(shape, 40);
    const rtl::ProgramMemory memory = rtl::program_memory(program, *rc::gen::inRange(1U, 257U));
    const std::size_t digits = fmt::format("{:x}", memory.word_count).size();
    for (std::size_t from = 0; from < memory.begins.size(); from += digits + 1)
      RC_ASSERT(memory.begins.find('\n', from) == from + digits);
  }));
  // Words of 256 bits: SegmentStart, one per instruction, FrameEnd.
  isa::Program program = enabling(24);
  const auto first_line = [&](std::size_t instructions) {
    program.segments[0].instructions.assign(instructions, {.opcode = isa::Opcode::enable_all});
    const rtl::ProgramMemory memory = rtl::program_memory(program, 256);
    CHECK(memory.word_count == instructions + 2);
    return memory.begins.substr(0, memory.begins.find('\n'));
  };
  CHECK(first_line(1) == "0");
  CHECK(first_line(13) == "0");
  CHECK(first_line(14) == "00");
  CHECK(first_line(253) == "00");
  CHECK(first_line(254) == "000");
}

TEST_CASE("a board has serial-line ports and pins only in a design without a Program") {
  const isa::Program program = enabling(24);
  const Files drawn = rtl::design_files(small_machine(), &program);
  const Files bare = rtl::design_files(small_machine(), nullptr);
  const auto text = [](const Files& files, std::string_view path) { return find_file(files, path); };
  CHECK(has(text(bare, "board.v"),
            "  input wire clk,\n"
            "  input wire from_computer,  // the host's serial line\n"
            "  output wire to_computer,\n"
            "  output wire lamp_drawn,"));
  CHECK(has(text(drawn, "board.v"), "  input wire clk,\n  output wire lamp_drawn,"));
  CHECK(has(text(bare, "board.v"),
            ".reset(reset), .from_computer(from_computer), .to_computer(to_computer), .told(), .told_any(),"));
  CHECK(has(text(drawn, "board.v"), ".reset(reset), .request(), .request_from(), .told(), .told_any(),"));
  CHECK(has(text(drawn, "board.v"), "  wire [48-1:0] colours;\n"));
  CHECK(has(text(drawn, "board.v"), "  assign video[11:0] = {colours[23:20], colours[15:12], colours[7:4]};\n"));
  CHECK(text(bare, "hx8k.pcf").ends_with("lamp_shown B4\nset_io from_computer B10\nset_io to_computer B12\n"));
  CHECK(text(drawn, "hx8k.pcf").ends_with("lamp_shown B4\n\n"));
  CHECK(text(bare, "up5k.pcf").ends_with("lamp_shown 37\nset_io from_computer 6\nset_io to_computer 9\n"));
  CHECK(text(drawn, "up5k.pcf").ends_with("lamp_shown 37\n\n"));
}

TEST_CASE("README and Makefile and system.v fit a design with a Program and one without") {
  const machines::Machine machine = small_machine();
  const isa::Program program = enabling(24);
  const Files drawn = rtl::design_files(machine, &program);
  const Files bare = rtl::design_files(machine, nullptr);
  const std::string title = "# " + machine.name + " in Verilog\n\n8 x 8 pixels, ";
  CHECK(find_file(drawn, "README.md").starts_with(title + "with a Program in memory."));
  CHECK(find_file(bare, "README.md").starts_with(title + "fed over a serial line."));
  for (const Files& files : {drawn, bare}) {
    CHECK(has(find_file(files, "README.md"), "## What fits\n\n| machine | part | pixels |"));
    CHECK(find_file(files, "Makefile").starts_with("# The design of " + machine.name + ", 8 x 8 pixels."));
  }
  CHECK(find_file(drawn, "system.v").starts_with("// " + machine.name + ", with a Program in the host's memory.\n"));
  CHECK(find_file(bare, "system.v").starts_with("// " + machine.name + ", with the host at the other end"));
  CHECK(has(find_file(bare, "system.v"), "  wire [32-1:0] word;\n"));
  CHECK(has(find_file(drawn, "system.v"), "  wire [32-1:0] word;\n"));
  CHECK(has(find_file(drawn, "Makefile"), "\nicarus: icarus.png\n"));
  CHECK(has(find_file(bare, "Makefile"), "\nicarus verilator waves:\n"));
}

TEST_CASE("a board shows one or two colour bits with zeros for channels without bits") {
  const isa::Program one = enabling(1);
  const std::string board = find_file(rtl::design_files(small_machine(), &one), "board.v");
  CHECK(has(board, "  assign video[2:0] = {1'd0, colours[0:0], 1'd0};\n"));
  CHECK(has(board, "  assign video[5:3] = {1'd0, colours[1:1], 1'd0};\n"));
  const isa::Program two = enabling(2);
  CHECK(has(find_file(rtl::design_files(small_machine(), &two), "board.v"),
            "  assign video[2:0] = {colours[1:1], colours[0:0], 1'd0};\n"));
}

TEST_CASE("pixels have the root flag if any instruction of a segment takes a root") {
  const isa::Instruction enable{.opcode = isa::Opcode::enable_all};
  const isa::Instruction root{.opcode = isa::Opcode::root, .fields = {isa::Field{30, 5}}};
  const auto has_roots = [](const std::vector<std::vector<isa::Instruction>>& segments) {
    isa::Program program = enabling(24);
    program.segments.clear();
    for (const std::vector<isa::Instruction>& instructions : segments)
      program.segments.push_back({.region = {0, 0, 8, 8}, .instructions = instructions});
    for (const rtl::Parameter& parameter : rtl::verilog_parameters(small_machine(), &program))
      if (parameter.name == "ROOTS") return parameter.value;
    return ~0U;
  };
  CHECK(has_roots({{enable, root}}) == 1);
  CHECK(has_roots({{root, enable}}) == 1);
  CHECK(has_roots({{}, {enable, root, enable}}) == 1);
  CHECK(has_roots({{enable, enable}, {}}) == 0);
  CHECK(has_roots({}) == 0);
}

TEST_CASE("a template's names are capitals and underscores between two at signs") {
  const std::vector<rtl::Filling> fillings{{"A", "1"}, {"A_B", "two"}, {"NOTHING", ""}};
  const auto filled = [&](std::string_view text) { return rtl::fill_template(text, fillings); };
  CHECK(filled("") == "");
  CHECK(filled("@A@") == "1");
  CHECK(filled("@A@@A_B@@NOTHING@x") == "1twox");
  CHECK(filled("@@") == "@@");
  CHECK(filled("@@A@") == "@1");
  CHECK(filled("@A") == "@A");
  CHECK(filled("@A_B") == "@A_B");
  CHECK(filled("A@") == "A@");
  CHECK(filled("@(A@ @b@ @A B@") == "@(A@ @b@ @A B@");
  CHECK(filled("@x@A@y") == "@x1y");
  CHECK_THROWS_WITH_AS(filled("@A@@B@"), "a template's @B@ has no value", std::logic_error);
  CHECK_THROWS_AS(rtl::template_text("none.v"), std::out_of_range);
}

TEST_CASE("a board with default settings has no serial line and no video") {
  std::vector<rtl::Filling> fillings;
  rtl::add_board(fillings, {.colour_bits = 24});
  CHECK(
      rtl::fill_template(
          "@CHANNEL_BITS@|@BOARD_VIDEO@|@BOARD_PORTS@|@BOARD_CONNECTIONS@|@BOARD_LINE_HX@|@BOARD_LINE_UP@", fillings) ==
      "4||"
      "|.request(), .request_from(), ||");
}