// SystemC elaborates once a process, so each case here runs in a process of its own, as ctest does it.

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "hw/base/error.h"
#include "hw/machines/regions.h"
#include "hw/scan_line/scan_line_array.h"
#include "sim/cycle/record.h"
#include "sim/engine/engine.h"

namespace {

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;

constexpr Field colour{0, 8};

machines::Machine machine_of(std::uint32_t cells, machines::Size picture, std::uint32_t chains = 1) {
  machines::Machine machine;
  machine.name = "test";
  machine.kind = machines::Kind::scan_line;
  machine.array = {cells, 1, 64};
  machine.picture = picture;
  machine.clock_hz = 1'000'000;
  machine.scan_line = {.words = 2, .word_bits = 32, .chains = chains, .packet_interval = 1, .refresh_hz = 50};
  return machine;
}

/// Each line with these instructions.
isa::Program program_of(const machines::Machine& machine, const std::vector<Instruction>& instructions) {
  isa::Program program;
  program.shape = {machine.picture.width, machine.picture.height, 64};
  program.fields = {{"colour", colour, isa::FieldRole::colour}};
  program.compile.background = 77;
  for (const isa::Region& region : machines::regions(machine)) {
    program.segments.push_back({.region = region, .instructions = instructions});
  }
  return program;
}

/// colour := 3 * x + 1
std::vector<Instruction> ramp() {
  return {{.opcode = Opcode::enable_all},
          {.opcode = Opcode::load_linear, .fields = {colour}, .linear = {.a = 3, .c = 1, .width = 10}}};
}

}  // namespace

TEST_CASE("a frame of one line takes the entry of its packets and mark, the way through the cells, and the way back") {
  const machines::Machine machine = machine_of(6, {4, 1});
  const sim::RunResult result = sim::make_cycle_engine(machine)->run(program_of(machine, ramp()), {});
  CHECK(result.clocks == 2 + 1 + 4 + 4);
  CHECK(result.latency_clocks == 0);
  CHECK(result.scanned_out == std::vector<std::uint32_t>{1, 4, 7, 10});
  const machines::LineAccount expected{.lines = 1,
                                       .packets = 2,
                                       .most_packets = 2,
                                       .line_budget = 20'000,
                                       .late_lines = 0,
                                       .entry_clocks = 3,
                                       .refresh_clocks = 0,
                                       .fill_clocks = 4,
                                       .drain_clocks = 8,
                                       .busy_cells = 8};
  CHECK(std::get<machines::LineAccount>(result.account) == expected);
}

TEST_CASE("lines with few packets follow one another as the refresh path takes them") {
  const machines::Machine machine = machine_of(16, {16, 3});
  const sim::RunResult result = sim::make_cycle_engine(machine)->run(program_of(machine, ramp()), {});
  CHECK(result.clocks == 3 + 16 + 16 + 2 * 16);
  CHECK(std::get<machines::LineAccount>(result.account).refresh_clocks == 2 * (16 - 3));
}

TEST_CASE("a line without instructions shows the background and takes its mark and the refresh path") {
  const machines::Machine machine = machine_of(4, {4, 3});
  isa::Program program = program_of(machine, ramp());
  program.segments[1].instructions.clear();
  const sim::RunResult result = sim::make_cycle_engine(machine)->run(program, {});
  CHECK(result.scanned_out == std::vector<std::uint32_t>{1, 4, 7, 10, 77, 77, 77, 77, 1, 4, 7, 10});
  CHECK(result.clocks == 3 + 4 + 4 + 2 * 4);
}

TEST_CASE("what a listener throws comes out of run, and the machine can be used again") {
  struct Thrower final : sim::Observer {
    void after_instruction(const sim::Step&, const sim::PixelState&) override { throw std::runtime_error("enough"); }
  } thrower;
  const machines::Machine machine = machine_of(4, {4, 3}, 2);
  const isa::Program program = program_of(machine, ramp());
  const auto engine = sim::make_cycle_engine(machine);
  sim::Observer* const observers[] = {&thrower};
  CHECK_THROWS_WITH_AS(engine->run(program, observers), "enough", std::runtime_error);
  CHECK(engine->run(program, {}).scanned_out == std::vector<std::uint32_t>{1, 4, 7, 10, 1, 4, 7, 10, 1, 4, 7, 10});
}

TEST_CASE("an observer that reads a state it did not ask for is told so") {
  struct Curious final : sim::Observer {
    [[nodiscard]] bool reads_after(const Instruction&) const override { return false; }
    void after_instruction(const sim::Step&, const sim::PixelState& state) override {
      std::vector<std::uint64_t> words(1);
      state.read_enable(words);
    }
  } curious;
  const machines::Machine machine = machine_of(4, {4, 1});
  sim::Observer* const observers[] = {&curious};
  CHECK_THROWS_AS(sim::make_cycle_engine(machine)->run(program_of(machine, ramp()), observers), std::logic_error);
}

TEST_CASE("a question to the host, other segments than the lines and too much memory are refused at every level") {
  const machines::Machine machine = machine_of(4, {4, 2});
  for (const auto& engine :
       {sim::make_functional_engine(machine), sim::make_cycle_engine(machine), sim::make_reference_engine(machine)}) {
    CAPTURE(engine->level());
    CHECK_THROWS_WITH_AS(engine->run(program_of(machine, {{.opcode = Opcode::global_or}}), {}),
                         "segment 0, instruction 0: global_or needs a global OR, which the machine test does not have; "
                         "compile the model "
                         "for this machine, or take one of kind frame-buffer whose global_or.present is 1",
                         InputError);
    isa::Program whole = program_of(machine, {});
    whole.segments = {{.region = {0, 0, 4, 2}, .instructions = {}}};
    CHECK_THROWS_AS(engine->run(whole, {}), InputError);
    isa::Program wide = program_of(machine, {});
    wide.shape.memory_bits = 65;
    CHECK_THROWS_AS(engine->run(wide, {}), InputError);
    isa::Program long_lines = program_of(machine_of(5, {5, 2}), {});
    CHECK_THROWS_AS(engine->run(long_lines, {}), InputError);
  }
}

TEST_CASE("a SystemC machine of another kind in one process is refused") {
  const auto first = sim::make_cycle_engine(machine_of(4, {4, 2}));
  CHECK_NOTHROW(sim::make_cycle_engine(machine_of(4, {3, 9})));
  CHECK_THROWS_AS(sim::make_cycle_engine(machine_of(4, {4, 2}, 2)), std::logic_error);
  machines::Machine other = machine_of(4, {4, 2});
  other.kind = machines::Kind::frame_buffer;
  CHECK_THROWS_AS(sim::make_cycle_engine(other), std::logic_error);
}

TEST_CASE("waves of a scan-line array are refused") {
  const machines::Machine machine = machine_of(4, {4, 2});
  CHECK_THROWS_AS(sim::run_and_record(machine, program_of(machine, {}), {}, {}), InputError);
}
