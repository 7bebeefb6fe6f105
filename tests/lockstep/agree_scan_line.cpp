#include <rapidcheck.h>

#include <utility>
#include <vector>

#include "sim/cycle/clocked_engine.h"
#include "sim/observe/frame.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/lockstep.h"
#include "tests/lockstep/timed_machine.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

namespace {

/// What the engine's own pictures show.
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

}  // namespace

bool agree_scan_line(const machines::Machine& machine, unsigned instructions, const Allowed& allowed) {
  const auto judge = engine::make_reference_engine(machine);
  const auto drawing = engine::make_functional_engine(machine);
  TimedMachine hardware(machine);
  const auto engine = cycle::make_clocked_engine(machine, hardware);
  return rc::check("the clocked scan-line array agrees with the reference", [&] {
    const auto program = first_allowed(
        [&] { return *arbitrary_program_in_parts(machine, instructions, machine.evaluator_degree); }, allowed);
    check_lockstep(*judge, *engine, program, machine);
    hardware.check_timeline(program);
    if (*rc::gen::inRange(0, 3) == 0) hardware.check_wave(program, *judge);
    check_pictures(*drawing, *engine, program);
    RC_ASSERT(engine->run(program, {}).overflows == judge->run(program, {}).overflows);
  });
}

}  // namespace csgsim::test
