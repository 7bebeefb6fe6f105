#include <rapidcheck.h>

#include "hw/isa/program.h"
#include "hw/machines/runs_on.h"
#include "hw/multi_processor/refresh.h"
#include "tests/support/test.h"
#include "tests/unit/multi_processor/stage_timing.h"

using namespace csgsim;
using namespace csgsim::testing::stages;

TEST_CASE("only the nodes of a multi-processor stop in screen turns (hand calculation)") {
  Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  // A node's 32 bits take two turns; 20 turns a second, of 5 clocks every 50.
  machine.clock_hz = 1000;
  figures(machine).refresh = {.rate = 10, .bits = 16, .clocks = 5};
  const multi_processor::Refresh refresh(isa::frame_header(program), machine);
  CHECK(refresh.end_clock(0, 50) == 50);
  CHECK(refresh.end_clock(0, 51) == 56);
  CHECK(refresh.end_clock(50, 1) == 56);
  CHECK(refresh.end_clock(52, 1) == 56);
  CHECK(refresh.end_clock(52, 0) == 52);
  CHECK(refresh.end_clock(40, 60) == 110);
  const FrameAccount shown = account_of(program, machine);
  figures(machine).refresh.rate = 0;
  const FrameAccount account = account_of(program, machine);
  // Reception, transformation, the first pruning and broadcasts last until clock 817; turns follow at 850, 900, ...
  // 1250.
  const multi_processor::StageClocks& stages = account.stages;
  CHECK(stages.reception + stages.transformation + stages.first_pruning + stages.broadcasting == 817);
  CHECK(shown.stages.second_pruning == 393 + 8 * 5);
  CHECK(shown.stages.sharing == stages.sharing);
  CHECK(shown.stages.broadcasting == stages.broadcasting);
  CHECK(shown.stages.rendering > stages.rendering);
}

TEST_CASE("the clocks left by the screen equal a turn-by-turn simulation") {
  CHECK(rc::check([] {
    Machine machine = random_machine();
    machine.clock_hz = *rc::gen::inRange<std::uint64_t>(50, 5000);
    figures(machine).refresh = {*rc::gen::inRange<std::uint32_t>(1, 20), 8, *rc::gen::inRange<std::uint32_t>(1, 9)};
    const isa::Program program = any_program(machine);
    const isa::FrameHeader header = isa::frame_header(program);
    const multi_processor::Refresh refresh(header, machine);
    if (refresh.turns_per_second() * figures(machine).refresh.clocks >= machine.clock_hz) return;
    const auto begin = *rc::gen::inRange<std::uint64_t>(0, 3000);
    const auto clocks = *rc::gen::inRange<std::uint64_t>(0, 300);
    std::uint64_t left = clocks;
    std::uint64_t now = begin;
    while (left > 0) {
      // Start of the last turn that has begun.
      const std::uint64_t turn = now * refresh.turns_per_second() / machine.clock_hz;
      std::uint64_t first = 0;
      while (first * refresh.turns_per_second() < turn * machine.clock_hz) ++first;
      if (turn == 0 || now >= first + figures(machine).refresh.clocks) --left;
      ++now;
    }
    RC_ASSERT(refresh.end_clock(begin, clocks) == now);
  }));
}

TEST_CASE("a screen that takes all clocks of the nodes is rejected") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  machine.clock_hz = 1'000'000;
  figures(machine).refresh = {.rate = 100, .bits = 1, .clocks = 312};
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  ++figures(machine).refresh.clocks;
  CHECK_THROWS_WITH_AS(
      machines::check_runs_on(program, machine),
      "the screen takes 3200 turns per second of 313 clocks each, but the memories of four have 1000000 "
      "clocks per second, which leaves none for drawing; increase refresh.bits",
      InputError);
}