#include "hw/array/pixel_replay.h"

#include "hw/isa/opcodes.h"

namespace csgsim::array {

namespace {

/// Whether the function sets the carry independently of its old value.
bool sets_carry(AluFunction function) {
  return function == AluFunction::compare_from_0 || function == AluFunction::compare_from_1 ||
         function == AluFunction::less_from_0 || function == AluFunction::less_from_1 ||
         function == AluFunction::sum_from_0 || function == AluFunction::sum_with_1_from_0 ||
         function == AluFunction::difference_from_1;
}

}  // namespace

PixelReplay::PixelReplay(std::span<const Place> pixels, std::uint32_t memory_bits, const Sequencer& sequencer,
                         unsigned alu_bits)
    : pixels_(pixels, memory_bits, alu_bits), sequencer_(sequencer), all_latches_(low_bits(alu_bits)) {}

void PixelReplay::begin(const isa::Region& region) {
  pixels_.reset(region.width, region.height);
  carry_known_ = true;
  flag_known_ = true;
  unknown_latches_ = 0;
}

void PixelReplay::execute_where_enabled(const isa::Instruction& instruction) {
  // Squares are part of the next instruction and are never skipped.
  const bool acts = isa::acts_on_disabled(instruction.opcode) || instruction.opcode == isa::Opcode::squares;
  if (acts || pixels_.any_enabled()) return execute(instruction);
  tree_known_ = false;
  carry_known_ = false;
  flag_known_ = false;
  unknown_latches_ = all_latches_;
}

void PixelReplay::execute(const isa::Instruction& instruction) {
  const isa::Linear& linear = instruction.linear;
  sequencer_.begin(instruction);
  while (sequencer_.busy()) {
    const BitStep step = sequencer_.issue();
    if (step.root.token.active()) {
      const isa::Linear& squares = sequencer_.squares();
      tree_ = {.token = step.root.token,
               .a = static_cast<std::uint64_t>(linear.a),
               .b = static_cast<std::uint64_t>(linear.b),
               .c = static_cast<std::uint64_t>(linear.c),
               .xx = static_cast<std::uint64_t>(squares.a),
               .xy = static_cast<std::uint64_t>(squares.b),
               .yy = static_cast<std::uint64_t>(squares.c)};
      tree_known_ = true;
    }
    pixels_.step(step.pixels, tree_);
    if (!registers_known()) record_known_registers(step.pixels);
  }
}

void PixelReplay::record_known_registers(const ArrayStep& step) {
  if (sets_carry(step.function)) carry_known_ = true;
  if (step.function == AluFunction::root_first) flag_known_ = true;
  if (step.function == AluFunction::latch_x) unknown_latches_ &= ~low_bits(step.bits);
}

}  // namespace csgsim::array
