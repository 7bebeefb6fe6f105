#include <rapidcheck.h>

#include "hw/machines/regions.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/divided_program.h"
#include "tests/lockstep/parts.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

bool squares_agree(const machines::Machine& machine, unsigned max_instructions, systemc::EvaluatorForm evaluator,
                   const Allowed& is_allowed) {
  const auto any_program = [&] {
    return machines::division(machine)
               ? any_divided_program(machine)
               : *arbitrary_program_in_parts(machine, max_instructions, machine.evaluator_degree);
  };
  return parts_agree(
      "the clocked pixel-square machine has the predicted bits, picture, clocks, account and timeline", machine,
      [&] { return first_allowed(any_program, is_allowed); },
      [](const isa::Program& program, const TimedMachine& hardware) { hardware.check_timeline(program); }, evaluator);
}

}  // namespace csgsim::test
