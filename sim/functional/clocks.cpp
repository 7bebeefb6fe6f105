#include "sim/functional/clocks.h"

#include <algorithm>

#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "sim/engine/engine.h"

namespace csgsim::functional {

namespace {

bool may_skip(const isa::Segment& segment) {
  return std::any_of(segment.instructions.begin(), segment.instructions.end(), [](const isa::Instruction& instruction) {
    return instruction.opcode == isa::Opcode::skip_if_none;
  });
}

}  // namespace

std::uint64_t clocks_of_run(const isa::Program& program, const machines::Machine& machine) {
  if (std::none_of(program.segments.begin(), program.segments.end(), may_skip))
    return machines::clocks(program, machine);
  return engine::make_functional_engine(machine)->run(program, {}).clocks;
}

}  // namespace csgsim::functional
