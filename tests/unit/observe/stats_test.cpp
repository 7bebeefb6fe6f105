#include "sim/observe/stats.h"

#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/pixel_planes/kind.h"
#include "sim/observe/stats_json.h"
#include "tests/support/test.h"
#include "tests/unit/observe/fake_pixels.h"

using namespace csgsim;
using namespace isa;
using observe::Cost;

namespace {

const Instruction set_up{Opcode::enable_all, {}, {}, 0, {Purpose::setup, isa::no_primitive, isa::no_node}};
const Instruction renders{Opcode::enable_all, {}, {}, 0, {Purpose::render, 0, isa::no_node}};
const Instruction classifies{Opcode::copy, {}, {}, 0, {Purpose::classify, 0, 1}};
const Instruction merges{Opcode::copy, {}, {}, 0, {Purpose::merge, 1, isa::no_node}};

isa::Program program() {
  isa::Program program;
  program.shape = {8, 4, 16};
  program.facts->primitives = {"a", "b", "c"};
  program.segments = {{{0, 0, 5, 3}, {}}, {{5, 0, 1, 1}, {}}};
  return program;
}

const Cost& of(const observe::Stats& stats, Opcode opcode) { return stats.by_opcode[static_cast<std::size_t>(opcode)]; }
const Cost& of(const observe::Stats& stats, Purpose purpose) {
  return stats.by_purpose[static_cast<std::size_t>(purpose)];
}

Cost sum(std::span<const Cost> costs) {
  Cost all;
  for (const Cost& cost : costs) all += cost;
  return all;
}

}  // namespace

TEST_CASE("an instruction is charged its clocks at all and at enabled pixels of its segment") {
  observe::StatsObserver observer(program());
  const testing::FakePixels pixels({0, 0, 5, 3});
  observer.after_instruction({0, 0, set_up, 1, 0}, pixels);
  observer.after_instruction({0, 1, renders, 1, 15}, pixels);
  observer.after_instruction({0, 2, classifies, 20, 7}, pixels);
  observer.after_instruction({1, 0, merges, 30, 1}, pixels);
  const observe::Stats& stats = observer.stats();
  // Instructions, clocks, pixels (15 in the first segment and 1 in the second), enabled pixels.
  CHECK(stats.total == Cost{4, 52, 15 + 15 + 20 * 15 + 30, 15 + 20 * 7 + 30});
  CHECK(of(stats, Opcode::enable_all) == Cost{2, 2, 30, 15});
  CHECK(of(stats, Opcode::copy) == Cost{2, 50, 330, 170});
  CHECK(of(stats, Opcode::global_or) == Cost{});
  CHECK(of(stats, Purpose::setup) == Cost{1, 1, 15, 0});
  CHECK(of(stats, Purpose::classify) == Cost{1, 20, 300, 140});
  CHECK(of(stats, Purpose::shade) == Cost{});
  REQUIRE(stats.by_primitive.size() == 3);
  CHECK(stats.by_primitive[0] == Cost{2, 21, 315, 155});  // the primitive compared with is not charged
  CHECK(stats.by_primitive[1] == Cost{1, 30, 30, 30});
  CHECK(stats.by_primitive[2] == Cost{});
}

TEST_CASE("instructions of an effect at a primitive are charged to the effect") {
  isa::Program one = program();
  one.facts->compile.effects = {"flat", "shadows"};
  observe::StatsObserver observer(one);
  const testing::FakePixels pixels({0, 0, 5, 3});
  const Instruction shadow{Opcode::copy, {}, {}, 0, {Purpose::render, 1, isa::no_node, 1}};
  const Instruction flat{Opcode::copy, {}, {}, 0, {Purpose::shade, 1, isa::no_node, 0}};
  observer.after_instruction({0, 0, merges, 30, 0}, pixels);
  observer.after_instruction({0, 1, shadow, 7, 0}, pixels);
  observer.after_instruction({0, 2, flat, 5, 0}, pixels);
  CHECK(observer.stats().by_primitive[1].clocks == 42);
  CHECK(observer.stats().plain_by_primitive[1].clocks == 35);
  CHECK(observer.stats().by_effect[1].clocks == 7);
}

TEST_CASE("the clocks by opcode and by purpose and by primitive each add up to the total") {
  CHECK(rc::check([] {
    observe::StatsObserver observer(program());
    const testing::FakePixels pixels({0, 0, 5, 3});
    Cost of_none;
    const int steps = *rc::gen::inRange(0, 30);
    for (int i = 0; i < steps; ++i) {
      Instruction instruction;
      instruction.opcode = static_cast<Opcode>(*rc::gen::inRange<std::size_t>(0, isa::opcode_table.size()));
      instruction.origin.purpose = static_cast<Purpose>(*rc::gen::inRange<std::size_t>(0, isa::purpose_table.size()));
      instruction.origin.primitive = *rc::gen::element(0U, 1U, 2U, isa::no_primitive);
      const auto clocks = *rc::gen::inRange<std::uint64_t>(1, 60);
      observer.after_instruction({0, 0, instruction, clocks, 4}, pixels);
      if (instruction.origin.primitive == isa::no_primitive) of_none += {1, clocks, clocks * 15, clocks * 4};
    }
    const observe::Stats& stats = observer.stats();
    RC_ASSERT(stats.total.instructions == static_cast<std::uint64_t>(steps));
    RC_ASSERT(sum(stats.by_opcode) == stats.total);
    RC_ASSERT(sum(stats.by_purpose) == stats.total);
    Cost primitives = sum(stats.by_primitive);
    primitives += of_none;
    RC_ASSERT(primitives == stats.total);
  }));
}

TEST_CASE("stats in JSON have the clocks and seconds and memory in use and the account") {
  isa::Program one = program();
  one.facts->fields = {{"Z2", {0, 7}, isa::FieldRole::depth}, {"mask", {9, 1}, isa::FieldRole::mask}};
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.array = {8, 4, 16};
  machine.clock_hz = 1000;
  engine::RunResult result;
  result.clocks = 250;
  result.latency_clocks = 5;
  const observe::Stats stats = observe::StatsObserver(one).stats();
  const auto json = observe::to_json({one, machine, "functional", result, stats, 0.5});
  CHECK(json["clocks"] == 250);
  CHECK(json["simulated_seconds"] == 0.25);
  CHECK(json["memory"]["used_bits"] == 8);
  CHECK(json["memory"]["memory_bits"] == 16);
  CHECK(json["by_purpose"]["latency"]["clocks"] == 5);
  CHECK(json["segments"]["count"] == 2);
  CHECK(json["segments"]["drawn"] == 0);
  CHECK(json["account"]["parts"].empty());
}
