// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/isa/opcodes.h"
#include "hw/machines/regions.h"
#include "hw/pixel_planes/kind.h"
#include "hw/scan_line/account.h"
#include "hw/scan_line/figures.h"
#include "hw/scan_line/kind.h"
#include "hw/scan_line/scan_line_array.h"
#include "sim/cycle/sequence.h"
#include "sim/engine/engine.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

using isa::Field;
using isa::Instruction;
using isa::Opcode;

constexpr Field colour{0, 8};

machines::Machine machine_of(std::uint32_t cells, machines::Size picture, std::uint32_t chains = 1) {
  machines::Machine machine = machines::blank_machine(scan_line::kind);
  machine.name = "test";
  machine.array = {cells, 1, 64};
  machine.picture = picture;
  machine.clock_hz = 1'000'000;
  machine.own = scan_line::Figures{.words = 2, .word_bits = 32, .chains = chains, .refresh_hz = 50};
  return machine;
}

/// Clocks before the frame's first instruction enters: the host sends the line, the link takes it, the start of the
/// line crosses the link and is accepted, and the instruction follows.
constexpr std::uint64_t first_entry = 5;

/// A Program with these instructions in each line.
isa::Program program_of(const machines::Machine& machine, const std::vector<Instruction>& instructions) {
  isa::Program program;
  program.shape = {machine.picture.width, machine.picture.height, 64};
  program.colour = colour;
  program.background = 77;
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

TEST_CASE("a frame of one line takes the clocks of link and packet entry and cells") {
  const machines::Machine machine = machine_of(6, {4, 1});
  const engine::RunResult result = engine::make_cycle_engine(machine)->run(program_of(machine, ramp()), {});
  CHECK(result.clocks == first_entry + 2 + 1 + 4 + 4);
  CHECK(result.latency_clocks == 0);
  CHECK(result.scanned_out == std::vector<std::uint32_t>{1, 4, 7, 10});
  using enum scan_line::LineActivity;
  scan_line::LineAccount expected{.lines = 1,
                                  .packets = 2,
                                  .max_packets = 2,
                                  .line_budget = 20'000,
                                  .late_lines = 0,
                                  .link_words = 4,
                                  .entry_clocks = 3,
                                  .refresh_clocks = 0,
                                  .fill_clocks = first_entry + 4,
                                  .drain_clocks = 8,
                                  .busy_cells = 8};
  expected.host.add(starting, 1);
  expected.host.add(done, 15);
  expected.link.add(waiting_for_host, 1);
  expected.link.add(sending, 4);
  expected.link.add(done, 11);
  expected.entry.add(waiting_for_link, 5);
  expected.entry.add(entering, 3);
  expected.entry.add(done, 8);
  expected.refresh.add(waiting_for_line, 12);
  expected.refresh.add(showing, 4);
  CHECK(result.account == scan_line::account(expected, machine, result.clocks));
}

TEST_CASE("all cells below a tree act in one clock that follows entry by the tree's depth") {
  machines::Machine machine = machine_of(6, {4, 2});
  machines::kind_figures<scan_line::Figures>(machine).network = scan_line::Network::trees;
  machines::kind_figures<scan_line::Figures>(machine).tree_bits = 8;
  const engine::RunResult result = engine::make_cycle_engine(machine)->run(program_of(machine, ramp()), {});
  CHECK(result.scanned_out == std::vector<std::uint32_t>{1, 4, 7, 10, 1, 4, 7, 10});
  constexpr std::uint64_t levels = 3;
  // F of 10 bits arrives in two clocks; the second line begins with a word, and its mark follows one line later.
  constexpr std::uint64_t first_mark = first_entry + 3 + 1;
  CHECK(result.clocks == first_mark + 5 + levels + 1 + 4);
  CHECK(result.account.count("fill_clocks") == first_entry + 1 + levels);
  CHECK(result.account.count("drain_clocks") == levels + 1 + 4);
  CHECK(result.account.count("busy_cells") == 2 * 3 * 4);
}

TEST_CASE("the refresh path limits the rate of lines with few packets") {
  const machines::Machine machine = machine_of(16, {16, 3});
  const engine::RunResult result = engine::make_cycle_engine(machine)->run(program_of(machine, ramp()), {});
  CHECK(result.clocks == first_entry + 3 + 16 + 16 + 2 * 16);
  // A line consists of its start, two packets and the mark.
  CHECK(result.account.count("refresh_clocks") == 2 * (16 - 4));
}

TEST_CASE("a line without instructions shows the background after its mark and refresh") {
  const machines::Machine machine = machine_of(4, {4, 3});
  isa::Program program = program_of(machine, ramp());
  program.segments[1].instructions.clear();
  const engine::RunResult result = engine::make_cycle_engine(machine)->run(program, {});
  CHECK(result.scanned_out == std::vector<std::uint32_t>{1, 4, 7, 10, 77, 77, 77, 77, 1, 4, 7, 10});
  CHECK(result.clocks == first_entry + 3 + 4 + 4 + 2 * 4);
}

TEST_CASE("a frame enters the chain while the previous one leaves it") {
  const machines::Machine machine = machine_of(16, {16, 1});
  const std::vector<isa::Program> frames(3, program_of(machine, ramp()));
  engine::Observer nobody;
  const std::vector<engine::Observer*> observers(3, &nobody);
  const auto results = cycle::run_sequence(machine, frames, observers);
  constexpr std::uint64_t mark = first_entry + 3;
  constexpr std::uint64_t drain = 2 * 16;
  CHECK(results[0].clocks == mark + drain);
  CHECK(results[0].interval_clocks == mark);
  for (std::size_t i = 1; i < results.size(); ++i) {
    CHECK(results[i].interval_clocks == 16);
    CHECK(results[i].clocks == 16 + drain);
    CHECK(results[i].account.count("refresh_clocks") == 16 - mark);
    CHECK(results[i].account.count("drain_clocks") == drain);
    CHECK(results[i].account.count("busy_cells") == 2 * 16);
    CHECK(results[i].account.count("fill_clocks") == first_entry + 16);
    CHECK(results[i].scanned_out == results[0].scanned_out);
  }
  CHECK(engine::make_cycle_engine(machine)->run(frames.front(), {}).interval_clocks == 16);
}

TEST_CASE("run() rethrows a listener's exception and the machine remains usable") {
  struct Thrower final : engine::Observer {
    void after_instruction(const engine::Step&, const engine::PixelState&) override {
      throw std::runtime_error("enough");
    }
  } thrower;
  const machines::Machine machine = machine_of(4, {4, 3}, 2);
  const isa::Program program = program_of(machine, ramp());
  const auto engine = engine::make_cycle_engine(machine);
  engine::Observer* const observers[] = {&thrower};
  CHECK_THROWS_WITH_AS(engine->run(program, observers), "enough", std::runtime_error);
  CHECK(engine->run(program, {}).scanned_out == std::vector<std::uint32_t>{1, 4, 7, 10, 1, 4, 7, 10, 1, 4, 7, 10});
}

TEST_CASE("rejects an observer that reads a state without requesting it") {
  struct Curious final : engine::Observer {
    [[nodiscard]] bool reads_after(const Instruction&) const override { return false; }
    void after_instruction(const engine::Step&, const engine::PixelState& state) override {
      std::vector<std::uint64_t> words(1);
      state.read_enable(words);
    }
  } curious;
  const machines::Machine machine = machine_of(4, {4, 1});
  engine::Observer* const observers[] = {&curious};
  CHECK_THROWS_AS(engine::make_cycle_engine(machine)->run(program_of(machine, ramp()), observers), std::logic_error);
}

TEST_CASE("every level rejects queries and segments that are not lines and too much memory") {
  const machines::Machine machine = machine_of(4, {4, 2});
  for (const auto& engine : {engine::make_functional_engine(machine), engine::make_cycle_engine(machine),
                             engine::make_reference_engine(machine)}) {
    CAPTURE(engine->level());
    CHECK_THROWS_WITH_AS(engine->run(program_of(machine, {{.opcode = Opcode::global_or}}), {}),
                         "segment 0, instruction 0: global_or needs a global OR, which the machine test does not have; "
                         "compile the model "
                         "for this machine, or use one with global_or.present = 1",
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

TEST_CASE("rejects a second kind of SystemC machine in one process") {
  const auto first = engine::make_cycle_engine(machine_of(4, {4, 2}));
  CHECK_NOTHROW(engine::make_cycle_engine(machine_of(4, {3, 9})));
  CHECK_THROWS_AS(engine::make_cycle_engine(machine_of(4, {4, 2}, 2)), std::logic_error);
  const machines::Machine other = machines::blank_machine(pixel_planes::kind);
  CHECK_THROWS_AS(engine::make_cycle_engine(other), std::logic_error);
}
