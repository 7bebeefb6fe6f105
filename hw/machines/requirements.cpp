#include "hw/machines/requirements.h"

#include <fmt/format.h>

#include "hw/isa/error.h"
#include "hw/isa/operands.h"

namespace csgsim::machines {

void require_answers(const isa::Program& program, const Machine& machine) {
  if (answers(machine)) return;
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    const std::vector<isa::Instruction>& instructions = program.segments[s].instructions;
    for (std::size_t i = 0; i < instructions.size(); ++i) {
      if (!isa::asks(instructions[i].opcode)) continue;
      throw InputError(
          fmt::format("segment {}, instruction {}: {} needs a global OR, which the machine {} does not have; compile "
                      "the model for this machine, or take one whose global_or.present is 1",
                      s, i, isa::info(instructions[i].opcode).name, machine.name));
    }
  }
}

}  // namespace csgsim::machines
