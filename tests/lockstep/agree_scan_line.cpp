#include <fmt/format.h>
#include <rapidcheck.h>

#include <deque>
#include <utility>
#include <vector>

#include "hw/scan_line/timing.h"
#include "sim/cycle/clocked_engine.h"
#include "sim/cycle/sequence.h"
#include "sim/observe/frame.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/lockstep.h"
#include "tests/lockstep/timed_machine.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

namespace {

/// The pictures that the engine itself returns.
struct Pictures {
  observe::Frame frame;
  std::vector<std::uint32_t> scanned_out;
};

Pictures draw(engine::Engine& engine, const isa::Program& program) {
  observe::FrameObserver frame(program);
  engine::Observer* const observers[] = {&frame};
  engine::RunResult result = engine.run(program, observers);
  return {frame.frame(), std::move(result.scanned_out)};
}

void check_pictures(engine::Engine& judge, engine::Engine& engine, const isa::Program& program) {
  const Pictures expected = draw(judge, program);
  const Pictures actual = draw(engine, program);
  RC_ASSERT(actual.frame.colour == expected.frame.colour);
  RC_ASSERT(actual.frame.depth == expected.frame.depth);
  RC_ASSERT(actual.frame.owner == expected.frame.owner);
  const bool coloured = program.colour.width > 0;
  RC_ASSERT(actual.scanned_out == (coloured ? expected.frame.colour : std::vector<std::uint32_t>{}));
}

/// Frames of one machine, with an observer for each.
struct Sequence {
  std::vector<isa::Program> programs;
  std::deque<observe::FrameObserver> frames;
  std::vector<engine::Observer*> observers;
};

void add_random_frames(Sequence& sequence, const machines::Machine& machine, unsigned instructions,
                       const Allowed& allowed) {
  for (int i = 0; i < 4; ++i) {
    const unsigned most = *rc::gen::inRange(0U, instructions + 1);
    sequence.programs.push_back(
        first_allowed([&] { return *arbitrary_program_in_parts(machine, most, machine.evaluator_degree); }, allowed));
  }
  for (const isa::Program& program : sequence.programs)
    sequence.observers.push_back(&sequence.frames.emplace_back(program));
}

}  // namespace

bool scan_line_agrees_in_sequences(const machines::Machine& machine, unsigned max_instructions,
                                   const Allowed& is_allowed) {
  const auto judge = engine::make_functional_engine(machine);
  return rc::check("consecutive frames overlap in a scan-line array at the predicted clocks", [&] {
    Sequence sequence;
    add_random_frames(sequence, machine, max_instructions, is_allowed);
    const auto counted = cycle::run_sequence(machine, sequence.programs, sequence.observers);
    const auto expected = scan_line::time_line_sequence(sequence.programs, machine);
    for (std::size_t i = 0; i < counted.size(); ++i) {
      const machines::Account account = scan_line::account(expected[i].account, machine, expected[i].clocks);
      if (counted[i].clocks != expected[i].clocks || counted[i].account != account)
        RC_FAIL(fmt::format("frame {}: predicted {} clocks, counted {}", i, expected[i].clocks, show(counted[i])));
      RC_ASSERT(is_account_complete(counted[i]));
      RC_ASSERT(counted[i].interval_clocks == expected[i].interval_clocks);
      const Pictures alone = draw(*judge, sequence.programs[i]);
      const observe::Frame seen = sequence.frames[i].frame();
      RC_ASSERT(seen.colour == alone.frame.colour);
      RC_ASSERT(seen.owner == alone.frame.owner);
      if (sequence.programs[i].colour.width > 0) RC_ASSERT(counted[i].scanned_out == alone.frame.colour);
    }
  });
}

bool scan_line_agrees(const machines::Machine& machine, unsigned max_instructions, const Allowed& is_allowed) {
  const auto judge = engine::make_reference_engine(machine);
  const auto drawing = engine::make_functional_engine(machine);
  TimedMachine hardware(machine);
  const auto engine = cycle::make_clocked_engine(machine, hardware);
  return rc::check("the clocked scan-line array agrees with the reference", [&] {
    const auto program = first_allowed(
        [&] { return *arbitrary_program_in_parts(machine, max_instructions, machine.evaluator_degree); }, is_allowed);
    check_lockstep(*judge, *engine, program, machine);
    hardware.check_timeline(program);
    if (*rc::gen::inRange(0, 3) == 0) hardware.check_wave(program, *judge);
    check_pictures(*drawing, *engine, program);
    RC_ASSERT(engine->run(program, {}).overflows == judge->run(program, {}).overflows);
  });
}

}  // namespace csgsim::test
