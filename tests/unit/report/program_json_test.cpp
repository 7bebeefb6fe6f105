#include "sim/report/program_json.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "hw/isa/facts.h"
#include "hw/isa/instruction_numbers.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/text.h"
#include "sim/engine/engine.h"
#include "sim/report/drawing.h"
#include "tests/support/drawing.h"
#include "tests/unit/report/bitten_cube.h"

using namespace csgsim;
using Json = nlohmann::ordered_json;

namespace {

std::vector<std::string> lines_of(const Json& json) {
  std::istringstream in(json["instructions"].get<std::string>());
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("a Program for a page has each instruction as the text form has it, and the operands of each opcode") {
  for (const std::string machine : {"", "pixel-square", "pixel-planes-5"}) {
    CAPTURE(machine);
    const isa::Program program = testing::bitten_cube(machine).program;
    const Json json = report::program_json(program, {}, nullptr);
    const std::vector<std::string> lines = lines_of(json);
    REQUIRE(lines.size() == isa::first_numbers(program).back());
    std::size_t at = 0;
    REQUIRE(json["segments"].size() == program.segments.size());
    for (std::size_t s = 0; s < program.segments.size(); ++s) {
      CHECK(json["segments"][s][0] == program.segments[s].region.x);
      CHECK(json["segments"][s][4] == program.segments[s].instructions.size());
      for (const isa::Instruction& instruction : program.segments[s].instructions)
        CHECK(lines[at++] == isa::text_of(instruction, program.facts->fields) + '\t' +
                                 isa::text_of(instruction.origin, *program.facts));
    }
    CHECK(json["opcodes"].size() == isa::opcode_table.size());
    CHECK(json["opcodes"]["keep_max"] == Json{"target", "linear"});
    CHECK(json["opcodes"]["skip_if_none"] == Json{"count"});
    CHECK(json["primitives"].size() == 2);
    CHECK(json["places"].empty());
    CHECK(json["geometry"].empty());
  }
}

TEST_CASE("questions that skipped are those of the run") {
  const isa::Program program = testing::bitten_cube().program;
  const machines::Machine machine = testing::machine_of(program.shape);
  const engine::RunResult result = engine::make_functional_engine(machine)->run(program, {});
  const std::vector<std::uint64_t> firsts = isa::first_numbers(program);
  std::vector<std::uint64_t> skips;
  for (const machines::Skip& skip : result.skips) skips.push_back(firsts[skip.segment] + skip.index);
  CHECK(report::record_drawing(program, machine).skips == skips);
}

TEST_CASE("a Program that does not fit is left out, and that is told") {
  const isa::Program program = testing::bitten_cube().program;
  const machines::Machine machine = testing::machine_of(program.shape);
  const report::Drawing whole = report::record_drawing(program, machine);
  CHECK(whole.program.size() > 1000);
  CHECK(whole.told.find("holds the Program itself") != std::string::npos);
  const report::Drawing without = report::record_drawing(program, machine, {.program = 1000});
  CHECK(without.program.empty());
  CHECK(without.told.find("does not fit into 1,000 bytes") != std::string::npos);
  CHECK(without.steps.size() == whole.steps.size());
}
