#include "sim/functional/clocks.h"

#include <algorithm>

#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "sim/engine/engine.h"

namespace csgsim::functional {

bool may_skip(const isa::Program& program) {
  return std::ranges::any_of(program.segments, [](const isa::Segment& segment) {
    return std::ranges::find(segment.instructions, isa::Opcode::skip_if_none, &isa::Instruction::opcode) !=
           segment.instructions.end();
  });
}

std::vector<machines::Skip> skips_of_run(const isa::Program& program, const machines::Machine& machine) {
  if (!may_skip(program)) return {};
  return engine::make_functional_engine(machine)->run(program, {}).skips;
}

std::uint64_t clocks_of_run(const isa::Program& program, const machines::Machine& machine) {
  if (!may_skip(program)) return machines::clocks(program, machine);
  return engine::make_functional_engine(machine)->run(program, {}).clocks;
}

}  // namespace csgsim::functional
