#include "hw/machines/runs_on.h"

#include <fmt/format.h>

#include "hw/isa/error.h"

namespace csgsim::machines {

namespace {

constexpr std::uint64_t most_model_words = std::uint64_t{1} << 32U;
constexpr std::uint64_t most_clocks = std::uint64_t{1} << 60U;

bool asks(const isa::Instruction& instruction) {
  return isa::info(instruction.opcode).clock_class == isa::ClockClass::answer;
}

void check_questions(const isa::Segment& segment, std::size_t number, const Machine& machine) {
  for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
    if (!asks(segment.instructions[i])) continue;
    throw InputError(fmt::format(
        "segment {}, instruction {}: {} asks a question, and {} has no wire for the answer; "
        "compile without questions, or for a machine of kind {}",
        number, i, isa::info(segment.instructions[i].opcode).name, machine.name, name_of(Kind::frame_buffer)));
  }
}

void check_region(const isa::Region& region, std::size_t number, const Machine& machine) {
  if (region.width <= machine.array.width && region.height <= machine.array.height) return;
  throw InputError(
      fmt::format("segment {}: the region of {}x{} pixels is larger than the {}x{} of {}; compile for this "
                  "machine",
                  number, region.width, region.height, machine.array.width, machine.array.height, machine.name));
}

/// The clocks of the divider's tests stay countable.
void check_counts(const isa::Program& program, const Machine& machine) {
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

}  // namespace

void check_runs_on(const isa::Program& program, const Machine& machine) {
  if (machine.kind == Kind::frame_buffer) return;
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    check_questions(program.segments[s], s, machine);
    if (machine.kind == Kind::pixel_square) check_region(program.segments[s].region, s, machine);
  }
  if (machine.kind == Kind::pixel_square) check_counts(program, machine);
}

}  // namespace csgsim::machines
