#include <rapidcheck.h>

#include <utility>
#include <vector>

#include "hw/isa/opcodes.h"
#include "sim/cycle/clocked_engine.h"
#include "sim/observe/frame.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/lockstep.h"
#include "tests/lockstep/timed_machine.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

namespace {

/// A random Program that sometimes ends with a query to the host.
isa::Program random_program(const machines::Machine& machine, unsigned instructions) {
  isa::Program program = *arbitrary_program_in_parts(machine, instructions, machine.evaluator_degree);
  if (*rc::gen::inRange(0, 3) == 0) program.segments.front().instructions.push_back({.opcode = isa::Opcode::global_or});
  return program;
}

void check_picture(engine::Engine& judge, engine::Engine& engine, const isa::Program& program) {
  observe::FrameObserver expected(program);
  engine::Observer* const expecting[] = {&expected};
  judge.run(program, expecting);
  const bool coloured = program.colour.width > 0;
  RC_ASSERT(engine.run(program, {}).scanned_out == (coloured ? expected.frame().colour : std::vector<std::uint32_t>{}));
}

}  // namespace

bool memory_agrees(const machines::Machine& machine, unsigned max_instructions, const Allowed& is_allowed) {
  const auto judge = engine::make_reference_engine(machine);
  const auto drawing = engine::make_functional_engine(machine);
  TimedMachine hardware(machine);
  const auto engine = cycle::make_clocked_engine(machine, hardware);
  return rc::check("the clocked memory agrees with the reference", [&] {
    const auto program = first_allowed([&] { return random_program(machine, max_instructions); }, is_allowed);
    check_lockstep(*judge, *engine, program, machine);
    hardware.check_timeline(program);
    if (*rc::gen::inRange(0, 6) == 0) hardware.check_wave(program, *judge);
    check_picture(*drawing, *engine, program);
    RC_ASSERT(engine->run(program, {}).overflows == judge->run(program, {}).overflows);
  });
}

}  // namespace csgsim::test
