#include "hw/machines/runs_on.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "hw/base/error.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/machines/kind.h"
#include "hw/machines/regions.h"

namespace csgsim::machines {

namespace {

void check_questions(const isa::Program& program, const Machine& machine) {
  if (has_global_or(machine)) return;
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    const std::vector<isa::Instruction>& instructions = program.segments[s].instructions;
    for (std::size_t i = 0; i < instructions.size(); ++i) {
      if (!isa::needs_global_or(instructions[i].opcode)) continue;
      throw InputError(
          fmt::format("segment {}, instruction {}: {} needs a global OR, which the machine {} does not have; compile "
                      "the model for this machine, or use one with global_or.present = 1",
                      s, i, isa::name_of(instructions[i].opcode), machine.name));
    }
  }
}

void check_squares(const isa::Program& program, const Machine& machine) {
  if (machine.evaluator_degree >= 2) return;
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    const std::vector<isa::Instruction>& instructions = program.segments[s].instructions;
    const auto found = std::ranges::find(instructions, isa::Opcode::squares, &isa::Instruction::opcode);
    if (found == instructions.end()) continue;
    throw InputError(
        fmt::format("segment {}, instruction {}: {} needs quadratic expressions, which the machine {} does not have; "
                    "compile the model for this machine, or use one with evaluator.degree = 2, such as pixel-powers",
                    s, found - instructions.begin(), isa::name_of(found->opcode), machine.name));
  }
}

}  // namespace

void check_parts(const isa::Program& program, const Machine& machine) {
  if (program.shape.memory_bits > machine.array.memory_bits) {
    throw InputError(fmt::format("the Program needs pixels with {} bits, but {} has {}; compile it for this machine",
                                 program.shape.memory_bits, machine.name, machine.array.memory_bits));
  }
  Machine drawing = machine;
  set_picture_size(drawing, {program.shape.width, program.shape.height});
  const std::vector<isa::Region> parts = regions(drawing);
  const bool alike = std::equal(parts.begin(), parts.end(), program.segments.begin(), program.segments.end(),
                                [](const isa::Region& part, const isa::Segment& one) { return part == one.region; });
  if (!alike) {
    throw InputError(
        fmt::format("the Program's segments are not the {} regions that {} uses for a picture of {}x{}; "
                    "compile it for this machine",
                    parts.size(), machine.name, program.shape.width, program.shape.height));
  }
}

void check_runs_on(const isa::Program& program, const Machine& machine) {
  check_questions(program, machine);
  check_squares(program, machine);
  machine.kind->check(program, machine);
}

}  // namespace csgsim::machines
