#include "sim/rtl/design.h"

#include <rapidcheck.h>

#include "hw/isa/wire.h"
#include "hw/kinds/load.h"
#include "sim/rtl/board.h"
#include "sim/rtl/parameters.h"
#include "sim/rtl/program_memory.h"
#include "sim/rtl/template.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

std::uint32_t value_of(const std::vector<rtl::Parameter>& parameters, std::string_view name) {
  const auto found = std::ranges::find(parameters, name, &rtl::Parameter::name);
  REQUIRE(found != parameters.end());
  return found->value;
}

std::string refusal(const std::string& machine) {
  return testing::error_of([&] { rtl::verilog_parameters(kinds::load(machine)); });
}

std::vector<std::string> split_lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Returns a word from hexadecimal digits.
isa::LinkWord parse_word(const std::string& digits) {
  isa::LinkWord word;
  for (std::size_t i = 0; i < digits.size(); ++i)
    word.put(static_cast<unsigned>(4 * (digits.size() - 1 - i)), 4, std::stoul(digits.substr(i, 1), nullptr, 16));
  return word;
}

}  // namespace

TEST_CASE("parameters of a machine file become parameters of the Verilog") {
  const auto parameters = rtl::verilog_parameters(
      kinds::load("pixel-planes-4", {"array.width=12", "array.memory_bits=90", "alu.bits=3", "scan_out.port=own",
                                     "scan_out.buffers=2", "global_or.fan_in=ideal", "memory.clear_clocks=ideal"}));
  CHECK(value_of(parameters, "WIDTH") == 12);
  CHECK(value_of(parameters, "HEIGHT") == 512);
  CHECK(value_of(parameters, "MEMORY_BITS") == 90);
  CHECK(value_of(parameters, "ALU_BITS") == 3);
  CHECK(value_of(parameters, "SCAN_SHARED") == 0);
  CHECK(value_of(parameters, "BUFFERS") == 2);
  CHECK(value_of(parameters, "FAN_IN") == 0);
  CHECK(value_of(parameters, "CLEAR_CLOCKS") == 1);
  CHECK(value_of(parameters, "ROOTS") == 0);
  CHECK(value_of(rtl::verilog_parameters(kinds::load("pixel-powers")), "DEGREE") == 2);
}

TEST_CASE("parameters that the Verilog lacks are rejected with a suggested fix") {
  CHECK(refusal("pixel-planes-4") == "");
  CHECK(refusal("scan-line") ==
        "scan-line is of the kind scan-line, which has no Verilog; use a machine of the kind frame-buffer, "
        "such as pixel-planes-4");
  CHECK(refusal("pixel-planes-4+alu.bits=2+evaluator.bits=2")
            .ends_with("evaluator.bits is 2, but the Verilog supports only 1; add --set evaluator.bits=1"));
  CHECK(refusal("pixel-planes-4+evaluator.register_levels=2").ends_with("add --set evaluator.register_levels=1"));
}

TEST_CASE("a Program's memory files hold its commands and the start of each instruction") {
  const isa::ArrayShape shape{.width = 16, .height = 16, .memory_bits = 72};
  CHECK(rc::check([&] {
    const isa::Program program = *test::arbitrary_program(shape, 12);
    const unsigned width = *rc::gen::inRange(1U, 257U);
    const rtl::ProgramMemory memory = rtl::program_memory(program, width);
    const std::vector<std::string> words = split_lines(memory.words);
    const std::vector<std::string> begins = split_lines(memory.begins);
    RC_ASSERT(words.size() == memory.word_count);
    RC_ASSERT(begins.size() == memory.begin_count);
    isa::WireDecoder decoder(width);
    std::vector<isa::Instruction> instructions;
    std::vector<std::size_t> first_words{0};  // number of the word after each instruction
    for (const std::string& word : words) {
      RC_ASSERT(word.size() == (width + 3) / 4);
      const auto command = decoder.take(parse_word(word));
      if (!command || !std::holds_alternative<isa::Instruction>(*command)) continue;
      instructions.push_back(std::get<isa::Instruction>(*command));
      first_words.push_back(static_cast<std::size_t>(&word - words.data()) + 1);
    }
    std::vector<isa::Instruction> sent;
    for (const isa::Segment& segment : program.segments)
      for (const isa::Instruction& instruction : segment.instructions) sent.push_back(isa::as_received(instruction));
    RC_ASSERT(instructions == sent);
    RC_ASSERT(begins.size() == first_words.size());
    for (std::size_t i = 0; i < begins.size(); ++i) RC_ASSERT(std::stoul(begins[i], nullptr, 16) == first_words[i]);
  }));
}

TEST_CASE("a template's names are replaced and text that only resembles one is kept") {
  const std::vector<rtl::Filling> fillings{{"WIDTH", "8"}, {"NOTHING", ""}};
  CHECK(rtl::fill_template("always @(posedge clk) w <= @WIDTH@;@NOTHING@ always @* @", fillings) ==
        "always @(posedge clk) w <= 8; always @* @");
  CHECK_THROWS_AS(rtl::fill_template("@HEIGHT@", fillings), std::logic_error);
}

TEST_CASE("a board shows the upper bits of each channel and zeros below a narrow one") {
  std::vector<rtl::Filling> fillings;
  rtl::add_board(fillings, {.colour_bits = 24, .scan_pixels = 2, .has_line = false});
  rtl::add_board(fillings, {.colour_bits = 8, .scan_pixels = 1, .has_line = true});
  CHECK(rtl::fill_template("@BOARD_VIDEO@", std::vector(fillings.begin(), fillings.end())) ==
        "  assign video[11:0] = {colours[23:20], colours[15:12], colours[7:4]};\n"
        "  assign video[23:12] = {colours[47:44], colours[39:36], colours[31:28]};\n");
  fillings.clear();
  rtl::add_board(fillings, {.colour_bits = 8, .scan_pixels = 1, .has_line = true});
  CHECK(rtl::fill_template("@BOARD_VIDEO@", fillings) ==
        "  assign video[8:0] = {colours[7:5], colours[4:2], colours[1:0], 1'd0};\n");
}

TEST_CASE("only a design with a Program has a memory file and a testbench") {
  const machines::Machine machine = kinds::load("pixel-planes-4", {"array.width=8", "array.height=8"});
  const auto has = [](const std::vector<rtl::DesignFile>& files, const std::string& path) {
    return std::ranges::find(files, path, &rtl::DesignFile::path) != files.end();
  };
  const auto bare = rtl::design_files(machine, nullptr);
  CHECK(has(bare, "rtl/pixel_planes.v"));
  CHECK(has(bare, "board.v"));
  CHECK(!has(bare, "testbench.v"));
  isa::Program program;
  program.shape = machine.array;
  program.segments.push_back({.region = {0, 0, 8, 8}, .instructions = {}});
  CHECK_THROWS_AS(rtl::design_files(machine, &program), InputError);
  program.colour = {0, 24};
  const auto drawn = rtl::design_files(machine, &program);
  CHECK(has(drawn, "program.hex"));
  CHECK(has(drawn, "testbench.v"));
}
