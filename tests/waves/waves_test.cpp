#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "tests/cli/cli.h"
#include "tests/waves/engine_state.h"
#include "tests/waves/vcd.h"

using namespace csgsim;

namespace {

using namespace csgsim::testing::cli;
using csgsim::test::EngineState;
using csgsim::test::Vcd;

struct Place {
  std::uint32_t x;
  std::uint32_t y;
};

/// A small picture of a model, and the window and pixels of its wave.
struct Case {
  std::string machine;
  std::string options;  ///< options of compile
  std::vector<Place> pixels;
  std::string window;
};

isa::Program compiled(const Case& one, const std::string& file) {
  const Outcome outcome = run("compile " + model("basics_csg") + " --view-all --machine " + one.machine + " " +
                              one.options + " -o " + file);
  REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
  return isa::load_program(file);
}

Vcd recorded(const Case& one, const std::string& program, const std::string& file, const std::string& more = "") {
  std::string words =
      "wave " + program + " --machine " + one.machine + " --window " + one.window + " -o " + file + more;
  for (const Place& pixel : one.pixels) words += fmt::format(" --pixel {},{}", pixel.x, pixel.y);
  const Outcome outcome = run(words);
  REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
  return Vcd(content(file));
}

/// Compares a wave of the case with the reference at every clock of the window; returns the number of comparisons.
std::size_t compare_with_engine(const Case& one, const std::string& top) {
  const Folder folder;
  const isa::Program program = compiled(one, folder / "p.csgt");
  const Vcd vcd = recorded(one, folder / "p.csgt", folder / "w.vcd");
  machines::Machine machine = kinds::load(one.machine);
  machines::adopt_shape(machine, program);
  const std::uint64_t period = 1'000'000'000'000 / machine.clock_hz;
  std::size_t compared = 0;
  for (const Place& pixel : one.pixels) {
    const EngineState state(program, machine, pixel.x, pixel.y);
    const std::string part = fmt::format("{}.pixel_{}_{}.", top, pixel.x, pixel.y);
    const std::uint64_t first = vcd.first_time() / period - 1;
    const std::uint64_t last = vcd.last_time() / period - 2;
    CHECK(first < last);
    for (std::uint64_t clock = first; clock <= last; ++clock) {
      const std::uint64_t middle = (clock + 1) * period + period / 2;
      CAPTURE(clock);
      CAPTURE(part);
      for (const isa::NamedField& named : program.facts->fields) {
        const auto expected = state.field_at(named.field, clock);
        if (!expected) continue;
        CAPTURE(named.name);
        REQUIRE(vcd.number_at(part + named.name, middle) == expected);
        ++compared;
      }
      if (const auto enable = state.enable_at(clock)) {
        REQUIRE(vcd.number_at(part + "enable", middle) == static_cast<std::uint64_t>(*enable));
        ++compared;
      }
    }
  }
  return compared;
}

const std::vector<Case> frame_buffers{
    {"pixel-planes-4", "--size 24x16", {{12, 8}, {3, 2}}, "200:2400"},
    {"pixel-planes-4+memory.reads=2+alu.bits=4", "--size 20x20", {{10, 11}}, "0:1500"},
    {"pixel-planes-4+alu.bits=8+evaluator.bits=3", "--size 20x20", {{10, 11}}, "0:1500"},
};

TEST_CASE("a wave of a frame buffer equals the reference at every clock") {
  for (const Case& one : frame_buffers) {
    CAPTURE(one.machine);
    CHECK(compare_with_engine(one, "frame_buffer") > 4000);
  }
}

TEST_CASE("a wave shows the instruction in progress at the pixels with its text") {
  const Case& one = frame_buffers.front();
  const Folder folder;
  const isa::Program program = compiled(one, folder / "p.csgt");
  const Vcd vcd = recorded(one, folder / "p.csgt", folder / "w.vcd");
  machines::Machine machine = kinds::load(one.machine);
  machines::adopt_shape(machine, program);
  const EngineState state(program, machine, 12, 8);
  std::size_t instructions = 0;
  for (std::uint64_t clock = 200; clock < 2400; ++clock) {
    const std::uint64_t middle = (clock + 1) * 100'000 + 50'000;
    const auto number = state.instruction_at(clock);
    CAPTURE(clock);
    REQUIRE(vcd.number_at("frame_buffer.pixels.instruction", middle) == number);
    const std::string text = vcd.at("frame_buffer.pixels.text", middle);
    if (!number) {
      CHECK(text == "-");
      continue;
    }
    ++instructions;
    const isa::Instruction& instruction = program.segments.front().instructions[*number];
    CHECK(text.rfind(std::string(isa::name_of(instruction.opcode)), 0) == 0);
    CHECK(vcd.at("frame_buffer.pixels.purpose", middle) == isa::info(instruction.origin.purpose).name);
    const std::string primitive = vcd.at("frame_buffer.pixels.primitive", middle);
    if (instruction.origin.primitive == isa::no_primitive) {
      CHECK(primitive == "-");
    } else {
      CHECK(primitive.find(program.facts->primitives[instruction.origin.primitive]) != std::string::npos);
    }
  }
  CHECK(instructions > 1500);
}

TEST_CASE("probed pixels that are simulated alone have the waves of the whole machine") {
  const std::string tree = " --probe tree.x:3 --probe tree.x:7 --probe tree.y:0 --probe tree.y:6";
  for (const std::string machine : {"pixel-planes-4", "pixel-planes-4+alu.bits=16+evaluator.bits=5",
                                    "pixel-planes-4+evaluator.register_levels=3"}) {
    CAPTURE(machine);
    const Case one{machine, "--size 70x40", {{35, 20}, {64, 3}}, ""};
    const Folder folder;
    compiled(one, folder / "p.csgt");
    for (const std::string window :
         {"--window 0:90", "--window primitive:2", "--window purpose:merge", "--at owner", "--window 2000:6000"}) {
      CAPTURE(window);
      const std::string words = "wave " + (folder / "p.csgt") + " --machine " + machine +
                                " --pixel 35,20 --pixel 64,3 " + window + tree + " -o ";
      require_success(run(words + (folder / "probed.vcd")));
      require_success(run(words + (folder / "whole.vcd") + " --whole"));
      CHECK(content(folder / "probed.vcd") == content(folder / "whole.vcd"));
      CHECK(content(folder / "probed.vcd").size() > 3000);
      CHECK_NOTHROW(Vcd(content(folder / "probed.vcd")));
    }
  }
}

TEST_CASE("the wave of stepped trees equals that of computed trees") {
  const std::string tree = " --probe tree.x:0 --probe tree.x:4 --probe tree.x:6 --probe tree.y:2 --probe tree.y:5";
  for (const std::string machine : {"pixel-planes-4", "pixel-planes-4+alu.bits=4+evaluator.bits=4",
                                    "pixel-planes-4+alu.bits=4+evaluator.bits=3+evaluator.register_levels=2"}) {
    CAPTURE(machine);
    const Case one{machine, "--size 37x21", {{35, 20}, {35, 3}}, ""};
    const Folder folder;
    compiled(one, folder / "p.csgt");
    for (const std::string more : {"--window 0:90", "--window purpose:merge", "--at owner --whole"}) {
      CAPTURE(more);
      const std::string words =
          "wave " + (folder / "p.csgt") + " --machine " + machine + " --pixel 35,20 --pixel 35,3 " + more + tree;
      require_success(run(words + " -o " + (folder / "stepped.vcd")));
      require_success(run(words + " --evaluator stepped -o " + (folder / "asked.vcd")));
      require_success(run(words + " --evaluator worked-out -o " + (folder / "worked_out.vcd")));
      CHECK(content(folder / "stepped.vcd") == content(folder / "worked_out.vcd"));
      CHECK(content(folder / "asked.vcd") == content(folder / "worked_out.vcd"));
    }
  }
}

/// 2^bits - 1.
std::int64_t mask(unsigned bits) { return (std::int64_t{1} << bits) - 1; }

/// Compares tree levels with the expression, for trees that deliver `tree_bits` bits per clock.
void check_levels(const std::string& machine_name, unsigned tree_bits, std::uint64_t clocks) {
  CAPTURE(machine_name);
  const Folder folder;
  const Case one{machine_name, "--size 16x8", {{11, 5}}, fmt::format("0:{}", clocks + 100)};
  const isa::Program program = compiled(one, folder / "p.csgt");
  const std::string tree = " --probe tree.x:0 --probe tree.x:2 --probe tree.x:4 --probe tree.y:3";
  const Vcd vcd = recorded(one, folder / "p.csgt", folder / "w.vcd", tree);
  // Level 2 on the path to x = 11, binary 1011, has received the bits of weight 8 and 4: C + 8 A.
  struct Level {
    std::string name;
    std::int64_t a;
    std::int64_t b;
    std::uint64_t delay;  ///< clocks from the root
  };
  std::size_t streams = 0;
  machines::Machine machine = kinds::load(machine_name);
  machines::adopt_shape(machine, program);
  const EngineState state(program, machine, 11, 5);
  for (const Level& level : {Level{"tree_x_0", 0, 0, 0}, Level{"tree_x_2", 8, 0, 2}, Level{"tree_x_4", 11, 0, 4},
                             Level{"tree_y_3", 11, 5, 7}}) {
    const std::string name = "frame_buffer.pixel_11_5." + level.name;
    CAPTURE(name);
    std::int64_t gathered = 0;
    for (std::uint64_t clock = 0; clock < clocks; ++clock) {
      const std::uint64_t middle = (clock + 1) * 100'000 + 50'000;
      const auto bit = vcd.number_at(name + "_bit", middle);
      if (!bit) continue;
      if (*bit == 0) gathered = 0;
      gathered |= static_cast<std::int64_t>(*vcd.number_at(name, middle)) << *bit;
      const auto number =
          state.instruction_at(clock + 7 - level.delay);  // the clock in which that bit reaches the pixels
      if (!number) continue;
      const isa::Linear& linear = program.segments.front().instructions[*number].linear;
      if (*bit + tree_bits < linear.width) continue;
      const std::int64_t sum = linear.a * level.a + linear.b * level.b + linear.c;
      REQUIRE(gathered == (sum & mask(linear.width)));
      ++streams;
    }
  }
  CHECK(streams > 100);
}

TEST_CASE("tree levels in a wave form A x + C and then A x + B y + C for any bits per clock") {
  check_levels("pixel-planes-4", 1, 3900);
  check_levels("pixel-planes-4+alu.bits=4+evaluator.bits=3", 3, 1900);
  check_levels("pixel-planes-4+alu.bits=32+evaluator.bits=32", 32, 700);
}

TEST_CASE("the wave of a field's last write ends with the clock that shows the result") {
  const Folder folder;
  const Case one{"pixel-planes-4", "--size 24x16", {{12, 8}}, ""};
  const isa::Program program = compiled(one, folder / "p.csgt");
  const Outcome outcome = run("wave " + (folder / "p.csgt") + " --pixel 12,8 --at Z2 -o " + (folder / "w.vcd"));
  REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
  const Vcd vcd(content(folder / "w.vcd"));
  machines::Machine machine = kinds::load(one.machine);
  machines::adopt_shape(machine, program);
  const EngineState state(program, machine, 12, 8);
  const auto z2 = std::ranges::find(program.facts->fields, "Z2", &isa::NamedField::name)->field;
  const std::uint64_t period = 100'000;
  const std::uint64_t last = vcd.last_time() / period - 2;
  const auto written = vcd.number_at("frame_buffer.pixel_12_8.Z2", (last + 1) * period + period / 2);
  CHECK(written == state.field_at(z2, last));
  CHECK(written != vcd.number_at("frame_buffer.pixel_12_8.Z2", vcd.first_time() + period / 2));
  CHECK(state.instruction_at(last) != state.instruction_at(last - 1));
}

TEST_CASE("a wave numbers its clocks and padding adds clocks at both ends of each window") {
  const Folder folder;
  const Case one{"pixel-planes-4", "--size 24x16", {{12, 8}}, "100:110"};
  compiled(one, folder / "p.csgt");
  const Vcd vcd = recorded(one, folder / "p.csgt", folder / "w.vcd", " --padding 7");
  constexpr std::uint64_t period = 100'000;
  CHECK(vcd.first_time() / period - 1 == 93);
  CHECK(vcd.last_time() / period - 2 == 116);
  for (std::uint64_t clock = 93; clock <= 116; ++clock)
    CHECK(vcd.number_at("frame_buffer.clock_number", (clock + 1) * period + period / 2) == clock);
}

TEST_CASE("a window's padding ends at the frame's start and at the largest clock number") {
  const Folder folder;
  const Case one{"pixel-planes-4", "--size 24x16", {{12, 8}}, ""};
  compiled(one, folder / "p.csgt");
  const std::string words = "wave " + (folder / "p.csgt") + " --pixel 12,8 --padding 7 -o " + (folder / "w.vcd");
  require_success(run(words + " --window 3:18446744073709551615"));
  const std::string file = content(folder / "w.vcd");
  CHECK(file.find("$enddefinitions $end\n#100000\n$dumpvars") != std::string::npos);
  CHECK(file.find("$dumpoff") == std::string::npos);
}

TEST_CASE("windows whose padding overlaps are merged into one") {
  const Folder folder;
  const Case apart{"pixel-planes-4", "--size 24x16", {{12, 8}}, ""};
  compiled(apart, folder / "p.csgt");
  const std::string words =
      "wave " + (folder / "p.csgt") + " --pixel 12,8 --window purpose:merge -o " + (folder / "w.vcd");
  require_success(run(words));
  CHECK(content(folder / "w.vcd").find("$dumpoff") != std::string::npos);
  require_success(run(words + " --padding 1000000"));
  CHECK(content(folder / "w.vcd").find("$dumpoff") == std::string::npos);
}

TEST_CASE("the size of a waveform file is proportional to its window") {
  const Folder folder;
  const Case one{"pixel-planes-4", "--size 32x32", {{16, 16}}, ""};
  compiled(one, folder / "p.csgt");
  const auto size_of = [&](const std::string& window) {
    REQUIRE(
        run("wave " + (folder / "p.csgt") + " --pixel 16,16 --window " + window + " -o " + (folder / "w.vcd")).code ==
        0);
    return content(folder / "w.vcd").size();
  };
  const auto header = content(folder / "p.csgt").empty() ? 0 : size_of("500:501");
  const auto one_part = size_of("500:1000") - header;
  const auto four_parts = size_of("500:2500") - header;
  CHECK(four_parts > 3 * one_part);
  CHECK(four_parts < 5 * one_part);
}

}  // namespace
