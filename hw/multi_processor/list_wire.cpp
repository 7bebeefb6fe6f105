#include "hw/multi_processor/list_wire.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/division/bit_stream.h"
#include "hw/division/encoding.h"
#include "hw/division/expression.h"
#include "hw/isa/opcodes.h"
#include "hw/multi_processor/records.h"

namespace csgsim::multi_processor {

namespace {

using isa::Instruction;
using isa::Opcode;

bool has_expression(Opcode opcode) {
  const isa::Operands& operands = isa::info(opcode).operands;
  return std::find(operands.begin(), operands.end(), isa::OperandKind::linear) != operands.end();
}

bool has_field(Opcode opcode) { return isa::info(opcode).operands[0] != isa::OperandKind::linear; }

/// Expression of a half-space in an instruction, `width` bits wide. A negative sign of a depth plane means that it is
/// within the range.
isa::Linear expression_of(const division::Plane& plane, Opcode opcode, const division::ModelHeader& header,
                          const isa::Region& square, unsigned width) {
  if (has_field(opcode)) return linear_of(division::depth_expression(header, plane), square, width);
  const bool is_end = opcode == Opcode::edge_negative && !plane.is_edge;
  return linear_of(division::line_expression(is_end ? division::depth_range_excess(header, plane) : plane), square,
                   width);
}

/// The first half-space that gives the instruction's expression.
std::size_t find_halfspace(const Instruction& instruction, const division::DisplayModel& model,
                           const isa::Region& square) {
  const isa::Linear wanted = isa::reduced(instruction.linear);
  const auto matches = [&](const division::Plane& plane) {
    return isa::reduced(expression_of(plane, instruction.opcode, model, square, wanted.width)) == wanted;
  };
  const auto found = std::find_if(model.planes.begin(), model.planes.end(), matches);
  if (found == model.planes.end()) throw std::logic_error("an expression of a list matches no half-space");
  return static_cast<std::size_t>(found - model.planes.begin());
}

void put_coefficients(division::BitWriter& out, const isa::Linear& linear) {
  for (const std::int64_t number : {linear.a, linear.b, linear.c}) out.put_signed(number, linear.width);
}

division::Bits encode_entry(const Instruction& instruction, const ListForm& form, const division::DisplayModel& model,
                            const isa::Region& square) {
  division::BitWriter out;
  out.put(static_cast<std::uint64_t>(instruction.opcode), isa::opcode_bits);
  if (has_field(instruction.opcode)) {
    out.put(instruction.fields[0].base, isa::wire_base_bits);
    out.put(instruction.fields[0].width, isa::wire_field_width_bits);
  }
  const bool uses_index = multi_processor::uses_index(instruction, form);
  out.put(uses_index ? 1 : 0, 1);
  if (uses_index) {
    out.put(find_halfspace(instruction, model, square), form.number_bits);
    out.put(instruction.linear.width, number_width_bits);
    return out.take();
  }
  out.put(instruction.linear.width, isa::wire_linear_width_bits);
  out.put(instruction.linear.shift, isa::wire_shift_bits);
  put_coefficients(out, instruction.linear);
  return out.take();
}

const Instruction* expression_instruction(const isa::Command& command, const ListForm& form) {
  const auto* const instruction = std::get_if<Instruction>(&command);
  const bool has_one = form.has_numbers && instruction != nullptr && has_expression(instruction->opcode);
  return has_one ? instruction : nullptr;
}

}  // namespace

std::vector<unsigned> entry_widths(const Instruction& instruction, const ListForm& form) {
  if (expression_instruction(instruction, form) == nullptr) {
    const isa::WireFields fields(instruction);
    return {fields.widths().begin(), fields.widths().end()};
  }
  std::vector<unsigned> numbers{isa::opcode_bits};
  if (has_field(instruction.opcode)) numbers.insert(numbers.end(), {isa::wire_base_bits, isa::wire_field_width_bits});
  const unsigned width = instruction.linear.width;
  if (uses_index(instruction, form)) {
    numbers.insert(numbers.end(), {1U, form.number_bits, number_width_bits});
  } else {
    numbers.insert(numbers.end(), {1U, isa::wire_linear_width_bits, isa::wire_shift_bits, width, width, width});
  }
  return numbers;
}

std::uint64_t entry_bits(const isa::Command& command, const ListForm& form) {
  const Instruction* const instruction = expression_instruction(command, form);
  if (instruction == nullptr) return isa::wire_bits(command);
  std::uint64_t bits = 0;
  for (const unsigned width : entry_widths(*instruction, form)) bits += width;
  return bits;
}

std::vector<isa::LinkWord> entry_words(const isa::Command& command, const ListForm& form,
                                       const division::DisplayModel& model, const isa::Region& square,
                                       unsigned word_bits) {
  if (const Instruction* const instruction = expression_instruction(command, form))
    return division::to_link(encode_entry(*instruction, form, model, square), word_bits);
  std::vector<isa::LinkWord> words;
  isa::encode(command, word_bits, [&](const isa::LinkWord& word) { words.push_back(word); });
  return words;
}

/// A command begins at a new word; its first bits identify it.
std::optional<isa::Command> ListReader::take(const isa::LinkWord& word, const ListForm& form,
                                             const division::DisplayModel& model) {
  std::vector<isa::LinkWord> next{word};
  if (!is_plain_) {
    held_.push_back(word);
    if (held_.size() * std::size_t{word_bits_} < isa::opcode_bits) return std::nullopt;
    if (std::optional<Instruction> instruction = decode_expression(form, model)) {
      held_.clear();
      return *instruction;
    }
    if (!is_plain_) return std::nullopt;
    next = std::exchange(held_, {});
  }
  std::optional<isa::Command> command;
  for (const isa::LinkWord& one : next) command = plain_.take(one);
  if (!command) return std::nullopt;
  is_plain_ = false;
  if (const auto* start = std::get_if<isa::SegmentStart>(&*command)) square_ = start->region;
  return command;
}

/// Decodes the expression if the held words are complete. Sets is_plain_ if the command has no expression.
std::optional<Instruction> ListReader::decode_expression(const ListForm& form, const division::DisplayModel& model) {
  division::BitWriter gathered;
  for (const isa::LinkWord& word : held_) append_word(gathered, word, word_bits_);
  const division::Bits bits = gathered.take();
  division::BitReader in(bits);
  const auto number = static_cast<std::uint8_t>(in.take(isa::opcode_bits));
  const bool is_control = number == isa::SegmentStart::number || number == isa::SegmentEnd::number;
  const auto opcode = static_cast<Opcode>(number);
  is_plain_ = !form.has_numbers || is_control || !has_expression(opcode);
  const unsigned field_bits = !is_plain_ && has_field(opcode) ? isa::wire_base_bits + isa::wire_field_width_bits : 0;
  if (is_plain_ || in.left() < field_bits + 1) return std::nullopt;
  Instruction instruction{.opcode = opcode};
  if (field_bits > 0) {
    instruction.fields[0].base = static_cast<std::uint16_t>(in.take(isa::wire_base_bits));
    instruction.fields[0].width = static_cast<std::uint16_t>(in.take(isa::wire_field_width_bits));
  }
  if (in.take(1) != 0) {
    if (in.left() < form.number_bits + number_width_bits) return std::nullopt;
    const std::uint64_t plane = in.take(form.number_bits);
    const auto width = static_cast<unsigned>(in.take(number_width_bits));
    if (plane >= model.planes.size()) throw InputError("a list on the bus refers to a nonexistent half-space");
    instruction.linear = isa::reduced(expression_of(model.planes[plane], opcode, model, square_, width));
    return instruction;
  }
  if (in.left() < isa::wire_linear_width_bits + isa::wire_shift_bits) return std::nullopt;
  isa::Linear& linear = instruction.linear;
  const auto width = static_cast<unsigned>(in.take(isa::wire_linear_width_bits));
  linear.shift = static_cast<std::uint16_t>(in.take(isa::wire_shift_bits));
  if (in.left() < 3 * std::uint64_t{width}) return std::nullopt;
  for (std::int64_t* const coefficient : {&linear.a, &linear.b, &linear.c}) *coefficient = in.take_signed(width);
  linear.width = static_cast<std::uint16_t>(width);
  return instruction;
}

}  // namespace csgsim::multi_processor
