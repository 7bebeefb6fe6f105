#include "hw/array/pixel_replay.h"

#include "hw/isa/opcodes.h"

namespace csgsim::array {

namespace {

/// Whether it may change memory or enable of a pixel that is not enabled, or what the next instruction does.
bool acts_where_none_is_enabled(isa::Opcode opcode) {
  switch (opcode) {
    case isa::Opcode::enable_all:
    case isa::Opcode::enable_invert:
    case isa::Opcode::enable_load:
    case isa::Opcode::enable_or:
    case isa::Opcode::enable_xor:
    case isa::Opcode::enable_store:
    case isa::Opcode::squares: return true;
    case isa::Opcode::enable_and:
    case isa::Opcode::enable_and_not:
    case isa::Opcode::edge_not_negative:
    case isa::Opcode::edge_negative:
    case isa::Opcode::linear_ge:
    case isa::Opcode::linear_gt:
    case isa::Opcode::linear_le:
    case isa::Opcode::linear_lt:
    case isa::Opcode::linear_eq:
    case isa::Opcode::load_linear:
    case isa::Opcode::keep_max:
    case isa::Opcode::keep_min:
    case isa::Opcode::set_constant:
    case isa::Opcode::copy:
    case isa::Opcode::field_lt:
    case isa::Opcode::field_le:
    case isa::Opcode::field_eq:
    case isa::Opcode::bit_and:
    case isa::Opcode::bit_or:
    case isa::Opcode::bit_xor:
    case isa::Opcode::bit_and_not:
    case isa::Opcode::bit_not:
    case isa::Opcode::global_or:
    case isa::Opcode::xor_constant:
    case isa::Opcode::skip_if_none:
    case isa::Opcode::add:
    case isa::Opcode::linear_plus:
    case isa::Opcode::linear_minus:
    case isa::Opcode::root:
    case isa::Opcode::stripe: break;
  }
  return false;
}

/// Whether it sets the carry whatever that was.
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
  knows_carry_ = true;
  knows_flag_ = true;
  unknown_latches_ = 0;
}

void PixelReplay::execute_where_enabled(const isa::Instruction& instruction) {
  if (acts_where_none_is_enabled(instruction.opcode) || pixels_.any_enabled()) return execute(instruction);
  knows_tree_ = false;
  knows_carry_ = false;
  knows_flag_ = false;
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
      knows_tree_ = true;
    }
    pixels_.step(step.pixels, tree_);
    if (!knows_registers()) note(step.pixels);
  }
}

void PixelReplay::note(const ArrayStep& step) {
  if (sets_carry(step.function)) knows_carry_ = true;
  if (step.function == AluFunction::root_first) knows_flag_ = true;
  if (step.function == AluFunction::latch_x) unknown_latches_ &= ~low_bits(step.bits);
}

}  // namespace csgsim::array
