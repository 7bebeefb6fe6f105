#include "hw/machines/runs_on.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "hw/base/error.h"
#include "hw/isa/operands.h"
#include "hw/machines/regions.h"

namespace csgsim::machines {

namespace {

constexpr std::uint64_t most_model_words = std::uint64_t{1} << 32U;
constexpr std::uint64_t most_clocks = std::uint64_t{1} << 60U;

void check_questions(const isa::Program& program, const Machine& machine) {
  if (answers(machine)) return;
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    const std::vector<isa::Instruction>& instructions = program.segments[s].instructions;
    for (std::size_t i = 0; i < instructions.size(); ++i) {
      if (!isa::asks(instructions[i].opcode)) continue;
      throw InputError(
          fmt::format("segment {}, instruction {}: {} needs a global OR, which the machine {} does not have; compile "
                      "the model for this machine, or take one of kind {} whose global_or.present is 1",
                      s, i, isa::info(instructions[i].opcode).name, machine.name, name_of(Kind::frame_buffer)));
    }
  }
}

void check_parts(const isa::Program& program, const Machine& machine) {
  if (program.shape.memory_bits > machine.array.memory_bits) {
    throw InputError(fmt::format("the Program is for pixels of {} bits, {} has {}; compile it for this machine",
                                 program.shape.memory_bits, machine.name, machine.array.memory_bits));
  }
  Machine drawing = machine;
  set_picture_size(drawing, {program.shape.width, program.shape.height});
  const std::vector<isa::Region> parts = regions(drawing);
  const bool alike = std::equal(parts.begin(), parts.end(), program.segments.begin(), program.segments.end(),
                                [](const isa::Region& part, const isa::Segment& one) { return part == one.region; });
  if (!alike) {
    throw InputError(
        fmt::format("the Program's segments are not the {} regions in which {} draws a picture of {}x{}; "
                    "compile it for this machine",
                    parts.size(), machine.name, program.shape.width, program.shape.height));
  }
}

}  // namespace

void check_countable(const isa::Program& program, const Machine& machine) {
  const PixelSquare& figures = machine.pixel_square;
  if (program.model.primitives > most_model_words || program.model.halfspaces > most_model_words) {
    throw InputError(fmt::format("a model of {} primitives of {} half-spaces; a pixel-square machine takes {} of each",
                                 program.model.primitives, program.model.halfspaces, most_model_words));
  }
  std::uint64_t clocks = 0;
  for (const isa::Segment& segment : program.segments) {
    clocks += program.model.primitives * figures.primitive_clocks +
              std::uint64_t{segment.halfspaces} * figures.halfspace_clocks;
    if (clocks > most_clocks) {
      throw InputError(
          fmt::format("the divider would test for more than {} clocks; give it a smaller model, or {} "
                      "fewer clocks a test",
                      most_clocks, machine.name));
    }
  }
}

void check_runs_on(const isa::Program& program, const Machine& machine) {
  check_questions(program, machine);
  if (machine.kind == Kind::frame_buffer) return;
  check_parts(program, machine);
  if (machine.kind == Kind::pixel_square) check_countable(program, machine);
}

}  // namespace csgsim::machines
