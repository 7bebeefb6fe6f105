#include "hw/array/sequencer.h"

#include <algorithm>

#include "hw/array/plane.h"
#include "hw/isa/opcodes.h"

namespace csgsim::array {

using isa::Opcode;

void Sequencer::begin(const isa::Instruction& instruction) {
  squares_ = instruction_.opcode == Opcode::squares ? instruction_.linear : isa::Linear{};
  instruction_ = instruction;
  busy_ = true;
  bit_ = instruction.opcode == Opcode::root ? instruction.fields[0].width - 3U : 0;
  pass_ = 0;
  trial_ = 0;
}

BitStep Sequencer::issue() {
  using enum AluFunction;
  const isa::Instruction& i = instruction_;
  switch (i.opcode) {
    case Opcode::enable_all: return single_step({.function = enable_all});
    case Opcode::enable_invert: return single_step({.function = enable_invert});
    case Opcode::enable_load: return single_step(enable_from_memory(enable_load));
    case Opcode::enable_and: return single_step(enable_from_memory(enable_and));
    case Opcode::enable_and_not: return single_step(enable_from_memory(enable_and_not));
    case Opcode::enable_or: return single_step(enable_from_memory(enable_or));
    case Opcode::enable_xor: return single_step(enable_from_memory(enable_xor));
    case Opcode::enable_store: return single_step({.function = store_enable, .write = i.fields[0].base});
    case Opcode::edge_not_negative: return next_stream_step({.sign = enable_and_not}, 1);
    case Opcode::edge_negative:
    case Opcode::stripe: return next_stream_step({.sign = enable_and}, 1);
    case Opcode::linear_ge: return next_stream_step(comparison_functions(compare_from_1, sign_enable), 1);
    case Opcode::linear_gt: return next_stream_step(comparison_functions(compare_from_0, sign_enable), 1);
    case Opcode::linear_le: return next_stream_step(comparison_functions(compare_from_0, sign_enable_not), 1);
    case Opcode::linear_lt: return next_stream_step(comparison_functions(compare_from_1, sign_enable_not), 1);
    case Opcode::linear_eq: return next_stream_step({enable_equal, enable_equal, enable_and_not, enable_and_not}, 1);
    case Opcode::load_linear: return next_stream_step(load_functions(store_x, enable_and_not), 1);
    case Opcode::keep_max: return next_stream_step(keep_functions(compare_from_0, sign_select), 2);
    case Opcode::keep_min: return next_stream_step(keep_functions(compare_from_1, sign_select_not), 2);
    case Opcode::set_constant: return next_field_step(store_step(store_constant));
    case Opcode::copy: return next_field_step(store_step(store_x));
    case Opcode::field_lt: return next_two_operand_step(less_step(compare_from_1, less_from_1));
    case Opcode::field_le: return next_two_operand_step(less_step(compare_from_0, less_from_0));
    case Opcode::field_eq:
      return next_two_operand_step({.function = enable_equal, .x = field_address(0), .y = field_address(1)});
    case Opcode::bit_and: return next_two_operand_step(store_step(store_and));
    case Opcode::bit_or: return next_two_operand_step(store_step(store_or));
    case Opcode::bit_xor: return next_two_operand_step(store_step(store_xor));
    case Opcode::bit_and_not: return next_two_operand_step(store_step(store_and_not));
    case Opcode::bit_not: return next_field_step(store_step(store_not_x));
    case Opcode::global_or:
    case Opcode::skip_if_none: return single_step({.function = answer});
    case Opcode::xor_constant: return next_field_step(read_modify_write_step(store_xor_constant));
    case Opcode::add: return next_two_operand_step(sum_step());
    case Opcode::squares: return single_step({});
    case Opcode::linear_plus: return next_stream_step({.first = sum_from_0, .field = sum}, 1);
    case Opcode::linear_minus: return next_stream_step({.first = difference_from_1, .field = difference}, 1);
    case Opcode::root: return next_trial_step();
  }
  busy_ = false;
  return {};
}

BitStep Sequencer::single_step(ArrayStep step) {
  busy_ = false;
  return {.root = {}, .pixels = step, .last = true};
}

/// Issues the bits of the linear expression that the trees deliver in a clock. The whole stream is sent `passes` times.
BitStep Sequencer::next_stream_step(const PositionFunctions& places, unsigned passes) {
  const ArrayStep step = linear_step(places);
  const isa::Linear& linear = instruction_.linear;
  const Token token{.bit = static_cast<std::int16_t>(bit_), .bits = stream_width()};
  const auto of = [&](std::int64_t coefficient) { return token.of(static_cast<std::uint64_t>(coefficient)); };
  const RootBits root{.token = token,
                      .a = of(linear.a),
                      .b = of(linear.b),
                      .c = of(linear.c),
                      .xx = of(squares_.a),
                      .xy = of(squares_.b),
                      .yy = of(squares_.c)};
  bit_ += token.bits;
  if (bit_ == linear.width) {
    bit_ = 0;
    ++pass_;
  }
  busy_ = pass_ < passes;
  return {.root = root, .pixels = step, .last = !busy_};
}

/// Issues the bits of a field instruction that the ALU processes in a clock.
BitStep Sequencer::next_field_step(ArrayStep step) {
  step.bits = step_bits();
  bit_ += step.bits;
  busy_ = bit_ < instruction_.fields[0].width;
  return {.root = {}, .pixels = step, .last = !busy_};
}

/// next_field_step() for two source operands x and y. With one read port, x is read into the operand latch one clock
/// before y; that clock is idle if x has no more bits.
BitStep Sequencer::next_two_operand_step(ArrayStep step) {
  if (!two_ports_ && pass_ == 0) {
    pass_ = 1;
    const std::uint16_t bits = second_bits();
    if (bits == 0) return {};
    return {.root = {},
            .pixels = {.function = AluFunction::latch_x, .source = OperandSource::memory, .x = step.x, .bits = bits}};
  }
  step.source = two_ports_ ? OperandSource::memory : OperandSource::latch;
  if (!two_ports_) step.x = 0;
  pass_ = 0;
  return next_field_step(step);
}

/// Issues one bit of a root trial. Trial k changes the remainder, the k + 3 field bits from bit 2(w-1-k) up: it
/// subtracts 4q + 1 or adds 4q + 3, where q is the k root bits above the remainder. With one read port, a bit of q is
/// latched one clock earlier.
BitStep Sequencer::next_trial_step() {
  const isa::Field field = instruction_.fields[0];
  const std::uint32_t bits = field.width / 2U;
  const std::uint32_t first = 2 * (bits - 1 - trial_);
  const std::uint32_t place = bit_ - first;
  const bool ends = place == trial_ + 2;
  ArrayStep step = trial_step(place);
  if (step.function == AluFunction::root_bit) {
    const auto of_root = static_cast<std::uint16_t>(field.base + 2 * bits - trial_ + place - 1);
    pass_ = two_ports_ ? 0 : 1 - pass_;
    if (pass_ == 1)
      return {.root = {}, .pixels = {.function = AluFunction::latch_x, .source = OperandSource::memory, .x = of_root}};
    step.source = two_ports_ ? OperandSource::memory : OperandSource::latch;
    step.x = two_ports_ ? of_root : std::uint16_t{0};
  }
  bit_ = ends ? first - 2 : bit_ + 1;
  if (ends) busy_ = ++trial_ < bits;
  return {.root = {}, .pixels = step, .last = !busy_};
}

/// The step of one bit of a root trial, counted from the lowest bit of the trial's number.
/// The lowest two bits of the added or subtracted number are constant. Its top bit is 0, as is the top bit of the first
/// remainder.
ArrayStep Sequencer::trial_step(std::uint32_t trial_bit_index) const {
  const auto step = [&](AluFunction function) {
    return ArrayStep{.function = function, .y = field_address(0), .write = field_address(0)};
  };
  if (trial_bit_index == 0) return step(AluFunction::sum_with_1_from_0);
  if (trial_bit_index == 1) return step(AluFunction::sum_with_1);
  if (trial_bit_index < trial_ + 2) return step(AluFunction::root_bit);
  if (trial_ > 0) return step(AluFunction::root_sign);
  return {.function = AluFunction::root_first, .write = field_address(0)};
}

Sequencer::BitCounts Sequencer::bit_counts() const {
  const isa::Linear& linear = instruction_.linear;
  const unsigned sign = bit_ + stream_width() == linear.width ? 1 : 0;
  const unsigned magnitude = stream_width() - sign;
  const auto before = [&](std::uint32_t end) { return std::clamp(end, bit_, bit_ + magnitude) - bit_; };
  const unsigned fraction = before(linear.shift);
  const unsigned to_field_end = before(linear.shift + instruction_.fields[0].width);
  return {fraction, to_field_end - fraction, magnitude - to_field_end, sign};
}

/// The step for the bits of F in this clock; its function is that of the first position that is not idle.
ArrayStep Sequencer::linear_step(const PositionFunctions& places) const {
  const BitCounts counts = bit_counts();
  const bool ends = counts.sign > 0 && places.sign != AluFunction::idle;
  const bool goes_beyond = counts.beyond > 0 && places.beyond != AluFunction::idle;
  ArrayStep step;
  if (counts.field > 0 && places.field != AluFunction::idle) {
    step = field_step(places, counts);
    if (goes_beyond) {
      step.beyond = places.beyond;
      step.beyond_bits = static_cast<std::uint16_t>(counts.beyond);
    }
  } else if (goes_beyond) {
    step.function = places.beyond;
    step.bits = static_cast<std::uint16_t>(counts.beyond);
    step.first = static_cast<std::uint16_t>(counts.fraction + counts.field);
  } else if (ends) {
    return {.function = places.sign, .first = static_cast<std::uint16_t>(stream_width() - 1)};
  }
  if (ends) step.sign = places.sign;
  return step;
}

/// Fills in the step for the bits of F that belong to the field.
ArrayStep Sequencer::field_step(const PositionFunctions& places, const BitCounts& counts) const {
  const std::uint32_t field_bit = bit_ + counts.fraction - instruction_.linear.shift;  // first field bit of this step
  const auto address = static_cast<std::uint16_t>(instruction_.fields[0].base + field_bit);
  const AluInfo& row = info(places.field);
  return {.function = field_bit == 0 ? places.first : places.field,
          .y = row.reads_y ? address : std::uint16_t{0},
          .write = row.writes ? address : std::uint16_t{0},
          .bits = static_cast<std::uint16_t>(counts.field),
          .constant = row.reads_y && row.writes ? static_cast<std::uint32_t>(low_bits(counts.field)) : 0,
          .first = static_cast<std::uint16_t>(counts.fraction)};
}

/// Bits of F in the next clock.
std::uint16_t Sequencer::stream_width() const {
  return static_cast<std::uint16_t>(std::min<std::uint32_t>(evaluator_bits_, instruction_.linear.width - bit_));
}

/// Address of the current bit of an operand's field.
std::uint16_t Sequencer::field_address(unsigned operand) const {
  return static_cast<std::uint16_t>(instruction_.fields[operand].base + bit_);
}

/// Number of field bits that the next step processes.
std::uint16_t Sequencer::step_bits() const {
  return static_cast<std::uint16_t>(std::min(alu_bits_, instruction_.fields[0].width - bit_));
}

/// Number of the step_bits() that lie within the second field.
std::uint16_t Sequencer::second_bits() const {
  const std::uint32_t width = instruction_.fields[1].width;
  return static_cast<std::uint16_t>(std::min<std::uint32_t>(step_bits(), width > bit_ ? width - bit_ : 0));
}

ArrayStep Sequencer::enable_from_memory(AluFunction function) const {
  return {.function = function, .source = OperandSource::memory, .x = instruction_.fields[0].base};
}

/// Compares by the carry of F - s, where s is 0 beyond the field; the sign bit of F decides.
Sequencer::PositionFunctions Sequencer::comparison_functions(AluFunction first_bit_function,
                                                             AluFunction sign_function) {
  return {first_bit_function, AluFunction::compare, AluFunction::compare_with_0, sign_function};
}

/// Writes the bits of F within the field and checks that those beyond the field are 0.
Sequencer::PositionFunctions Sequencer::load_functions(AluFunction field_function, AluFunction beyond_function) {
  return {field_function, field_function, beyond_function, beyond_function};
}

/// The first pass compares; the second pass writes where F was selected.
Sequencer::PositionFunctions Sequencer::keep_functions(AluFunction first_bit_function,
                                                       AluFunction sign_function) const {
  if (pass_ == 0) return comparison_functions(first_bit_function, sign_function);
  return load_functions(AluFunction::store_x_selected, AluFunction::enable_fits);
}

/// Writes the target, operand 0; the sources are operands 1 and 2.
ArrayStep Sequencer::store_step(AluFunction function) const {
  const AluInfo& row = info(function);
  const auto address = [&](unsigned operand) { return field_address(operand); };
  return {.function = function,
          .source = row.reads_x ? OperandSource::memory : OperandSource::tree,
          .x = row.reads_x ? address(1) : std::uint16_t{0},
          .y = row.reads_y ? address(2) : std::uint16_t{0},
          .write = address(0),
          .constant = static_cast<std::uint32_t>(instruction_.constant >> bit_ & low_bits(step_bits()))};
}

/// Reads the target, operand 0, and writes it back.
ArrayStep Sequencer::read_modify_write_step(AluFunction function) const {
  ArrayStep step = store_step(function);
  step.x = step.write;
  return step;
}

/// Adds the source, x, to the target.
ArrayStep Sequencer::sum_step() const {
  const std::uint16_t added = second_bits();
  if (added == 0) return {.function = AluFunction::sum_with_0, .y = field_address(0), .write = field_address(0)};
  return {.function = bit_ == 0 ? AluFunction::sum_from_0 : AluFunction::sum,
          .x = field_address(1),
          .y = field_address(0),
          .write = field_address(0),
          .constant = static_cast<std::uint32_t>(low_bits(added))};
}

/// Compares by the carry of s - r; the step with the last bit decides.
ArrayStep Sequencer::less_step(AluFunction compare_first, AluFunction decide_first) const {
  const bool first = bit_ == 0;
  const bool last = bit_ + step_bits() == instruction_.fields[0].width;
  const AluFunction compare = first ? compare_first : AluFunction::compare;
  const AluFunction decide = first ? decide_first : AluFunction::less;
  return {.function = last ? decide : compare, .x = field_address(0), .y = field_address(1)};
}

}  // namespace csgsim::array
