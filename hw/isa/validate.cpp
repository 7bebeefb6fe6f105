#include "hw/isa/validate.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/describe.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/pieces.h"

/// Formats a field as `[20+:22]`. fmt formats only messages that are thrown.
template <>
struct fmt::formatter<csgsim::isa::Field> : fmt::formatter<std::string_view> {
  auto format(csgsim::isa::Field field, fmt::format_context& context) const {
    return fmt::format_to(context.out(), "[{}+:{}]", field.base, field.width);
  }
};

namespace csgsim::isa {

namespace {

__extension__ using Wide = __int128;

template <class... Args>
void require(bool holds, fmt::format_string<Args...> message, Args&&... args) {
  if (!holds) throw InputError(fmt::format(message, std::forward<Args>(args)...));
}

void check_field(Field field, std::uint32_t memory_bits, unsigned most = max_field_width) {
  require(field.width >= 1 && field.width <= most, "field {} is {} bits wide; a field has 1 to {} bits", field,
          field.width, most);
  require(field.end() <= memory_bits, "field {} ends outside the {} memory bits of a pixel; place it below bit {}",
          field, memory_bits, memory_bits);
}

void check_operand(Field field, const OpcodeInfo& row, std::uint32_t memory_bits) {
  check_field(field, memory_bits, allows_wide_fields(row.opcode) ? max_wide_field_width : max_field_width);
  require(row.widths != FieldWidths::odd || (field.width % 2 == 1 && field.width >= 3),
          "{}: field {} is {} bits wide; use an odd number of bits, at least 3: twice the root's width plus 1",
          row.name, field, field.width);
}

void check_fields(const Instruction& instruction, const OpcodeInfo& row, std::uint32_t memory_bits) {
  const FieldWidths widths = row.widths;
  for (std::size_t i = 0; i < max_operands; ++i) {
    const Field field = instruction.fields[i];
    if (!is_field(row.operands[i])) {
      require(field == Field{}, "{}: operand {} is not a field; set fields[{}] to zero", row.name, i + 1, i);
      continue;
    }
    check_operand(field, row, memory_bits);
    require(widths != FieldWidths::one || field.width == 1, "{}: field {} is {} bits wide; use a single bit", row.name,
            field, field.width);
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_field(row.operands[j])) continue;
      const Field other = instruction.fields[j];
      if (widths == FieldWidths::narrower) {
        require(field.width <= other.width, "{}: field {} is wider than field {}; make it at most as wide", row.name,
                field, other);
      } else {
        require(field.width == other.width, "{}: fields {} and {} differ in width; make them equally wide", row.name,
                other, field);
      }
      if (widths == FieldWidths::elementwise) {
        require(field == other || !field.overlaps(other),
                "{}: fields {} and {} overlap in part; use the same field or separate fields", row.name, other, field);
      } else {
        require(!field.overlaps(other), "{}: fields {} and {} overlap; keep them apart", row.name, other, field);
      }
    }
  }
}

/// The width of the first field, with which F or the constant is combined; empty if there is no field.
std::optional<unsigned> combined_width(const Instruction& instruction, const OpcodeInfo& row) {
  if (!is_field(row.operands[0])) return std::nullopt;
  return instruction.fields[0].width;
}

void check_linear(const Instruction& instruction, const OpcodeInfo& row) {
  const Linear& linear = instruction.linear;
  const bool has_squares = has_operand(row.operands, OperandKind::squares);
  if (!has_operand(row.operands, OperandKind::linear) && !has_squares) {
    require(linear == Linear{}, "{} has no linear expression; set it to zero", row.name);
    return;
  }
  require(linear.width >= 1 && linear.width <= max_linear_width, "{}: the {} {} bits wide; use 1 to {} bits", row.name,
          has_squares ? "squares are" : "linear expression is", linear.width, max_linear_width);
  require(!has_squares || linear.shift == 0, "{}: squares have no shift; set it to zero", row.name);
  require(linear.shift < linear.width, "{}: shift {} drops all of the {} bits; use a smaller shift", row.name,
          linear.shift, linear.width);
  const unsigned kept = static_cast<unsigned>(linear.width) - linear.shift;
  const std::optional<unsigned> met = combined_width(instruction, row);
  require(!met || kept > *met,
          "{}: F has {} bits and is combined with a field of {}; F needs at least one bit more than the field, for its "
          "sign",
          row.name, kept, met.value_or(0));
}

void check_constant(const Instruction& instruction, const OpcodeInfo& row) {
  if (has_operand(row.operands, OperandKind::count)) {
    require(instruction.constant >= 1, "{} 0 skips nothing; skip at least one instruction, or remove it", row.name);
    require(instruction.constant <= max_count, "{} {}: it can skip at most {} instructions; split the skip", row.name,
            instruction.constant, max_count);
    return;
  }
  if (!has_operand(row.operands, OperandKind::constant)) {
    require(instruction.constant == 0, "{} has no constant; set it to zero", row.name);
    return;
  }
  const unsigned width = combined_width(instruction, row).value_or(0);
  require(instruction.constant >> width == 0, "{}: constant {} does not fit {} bits; widen the field", row.name,
          instruction.constant, width);
}

Wide magnitude(std::int64_t value) { return value < 0 ? -static_cast<Wide>(value) : static_cast<Wide>(value); }

void check_range(const Instruction& instruction, const Region& region) {
  if (!has_operand(operands_of(instruction.opcode), OperandKind::linear)) return;
  const Linear& linear = instruction.linear;
  const Wide bound = magnitude(linear.a) * region.width + magnitude(linear.b) * region.height + magnitude(linear.c);
  require(bound < static_cast<Wide>(1) << 62U,
          "{}: |A| * {} + |B| * {} + |C| reaches 2^62; use smaller coefficients or fewer fraction bits",
          name_of(instruction.opcode), region.width, region.height);
}

/// Checks the sum of squares and the linear expression after them.
void check_sum(const Linear& squares, const Linear& linear, const Region& region) {
  const Wide width = region.width;
  const Wide height = region.height;
  const Wide bound = magnitude(squares.a) * width * width + magnitude(squares.b) * width * height +
                     magnitude(squares.c) * height * height + magnitude(linear.a) * width +
                     magnitude(linear.b) * height + magnitude(linear.c);
  require(bound < static_cast<Wide>(1) << 62U,
          "squares: over {}x{} pixels the sum of |coefficient| * side * side, with the next instruction's, reaches "
          "2^62; use smaller coefficients or fewer fraction bits",
          region.width, region.height);
}

/// Checks squares against `following`, the instructions after them.
void check_squares(const Instruction& squares, std::span<const Instruction> following, const Region& region) {
  require(!following.empty(),
          "squares are the last instruction of the segment; put one with a linear expression "
          "after them");
  const Instruction& next = following.front();
  require(has_operand(operands_of(next.opcode), OperandKind::linear),
          "squares come before {}, which has no linear expression; put an instruction that has one right after them",
          name_of(next.opcode));
  require(next.linear.width == squares.linear.width,
          "squares of {} bits come before a linear expression of {}; make them equally wide", squares.linear.width,
          next.linear.width);
  check_sum(squares.linear, next.linear, region);
}

void check_index(std::uint32_t index, std::uint32_t none, const Program& program, std::string_view what) {
  require(index == none || index < piece_count(*program.facts),
          "the origin's {} is p{}, but the Program has {} primitives; name one that it lists", what, index,
          piece_count(*program.facts));
}

/// Runs a check and adds the place to its error text.
template <class Check, class... Args>
void check_at(const Check& check, fmt::format_string<Args...> place, Args&&... args) {
  try {
    check();
  } catch (const InputError& error) {
    throw InputError(fmt::format(place, std::forward<Args>(args)...) + ": " + error.what());
  }
}

}  // namespace

void validate(const Instruction& instruction, std::uint32_t memory_bits) {
  require(in_table(instruction.opcode), "opcode {} is undefined; the table has {}",
          static_cast<unsigned>(instruction.opcode), opcode_table.size());
  require(in_table(instruction.origin.purpose), "purpose {} is undefined; the table has {}",
          static_cast<unsigned>(instruction.origin.purpose), purpose_table.size());
  const OpcodeInfo& row = info(instruction.opcode);
  check_fields(instruction, row, memory_bits);
  check_linear(instruction, row);
  check_constant(instruction, row);
}

void validate_in_segment(const Instruction& instruction, const Region& region, const Program& program) {
  validate(instruction, program.shape.memory_bits);
  check_range(instruction, region);
  check_index(instruction.origin.primitive, no_primitive, program, "primitive");
  check_index(instruction.origin.node, no_node, program, "node");
  const std::size_t effects = program.facts->compile.effects.size();
  require(instruction.origin.effect == no_effect || instruction.origin.effect < effects,
          "the origin's effect is e{}, but the Program has {} effects; name one that .compile lists",
          instruction.origin.effect, effects);
}

void validate_with_successors(const Segment& segment, std::size_t index) {
  const Instruction& instruction = segment.instructions[index];
  const auto following = std::span(segment.instructions).subspan(index + 1);
  const OpcodeInfo& row = info(instruction.opcode);
  if (has_operand(row.operands, OperandKind::squares)) check_squares(instruction, following, segment.region);
  if (!has_operand(row.operands, OperandKind::count)) return;
  require(instruction.constant <= following.size(),
          "{} {} skips past the end of the segment, which has {} more instructions; skip at most these", row.name,
          instruction.constant, following.size());
  require(!has_operand(operands_of(following[static_cast<std::size_t>(instruction.constant) - 1].opcode),
                       OperandKind::squares),
          "{} {} ends between squares and their instruction; skip both or neither", row.name, instruction.constant);
}

void validate_field(const NamedField& named, const Program& program) {
  require(!named.name.empty(), "field {} has an empty name; name it", named.field);
  require(static_cast<std::size_t>(named.role) < field_role_names.size(), "field role {} is undefined; there are {}",
          static_cast<unsigned>(named.role), field_role_names.size());
  check_field(named.field, program.shape.memory_bits);
  require(named.role != FieldRole::colour || named.field == program.colour,
          "field {} has the role colour, but the frame displays {}; write .frame colour_base={} colour_bits={} before "
          "this field",
          named.field, program.colour.width == 0 ? "nothing" : fmt::format("{}", program.colour), named.field.base,
          named.field.width);
}

void validate_extent(const RowExtent& extent, const ArrayShape& shape) {
  require(
      extent.first <= extent.last && extent.last < shape.height,
      "the extent from row {} to row {} is reversed or outside a picture of {} rows; use rows of the picture, in order",
      extent.first, extent.last, shape.height);
}

void validate_region(const Region& region, const ArrayShape& shape) {
  require(region.width > 0 && region.height > 0, "the region of {}x{} pixels is empty; remove the segment",
          region.width, region.height);
  require(region.x < shape.width && region.width <= shape.width - region.x &&  //
              region.y < shape.height && region.height <= shape.height - region.y,
          "the region of {}x{} pixels at ({}, {}) extends beyond the picture of {}x{}; clip it", region.width,
          region.height, region.x, region.y, shape.width, shape.height);
}

void validate_header(const Program& program) {
  const ArrayShape& shape = program.shape;
  require(shape.width >= 1 && shape.width <= max_array_side && shape.height >= 1 && shape.height <= max_array_side,
          "the array has {}x{} pixels; each side must be 1 to {}", shape.width, shape.height, max_array_side);
  require(shape.memory_bits >= 1 && shape.memory_bits <= max_memory_bits,
          "a pixel has {} memory bits; it must have 1 to {}", shape.memory_bits, max_memory_bits);
  const DepthScale& depth = program.facts->depth_scale;
  require(std::isfinite(depth.near) && std::isfinite(depth.far) && depth.near < depth.far,
          "depth runs from {} to {}; use finite distances, with near below far", depth.near, depth.far);
  require(!depth.perspective || (depth.near > 0 && std::isfinite(1.0 / depth.near)),
          "near is {} in perspective; use a distance above 0 whose reciprocal is finite", depth.near);
  if (program.colour != Field{})
    check_at([&] { check_field(program.colour, shape.memory_bits); }, "the displayed field");
  require(program.background < 1U << max_colour_bits, "background is {}; a colour has at most {} bits",
          program.background, max_colour_bits);
  require(std::isfinite(program.facts->compile.edge_on_fraction),
          "edge_on_fraction is {}; use a finite fraction of a pixel", program.facts->compile.edge_on_fraction);
}

void validate_preparation(const Preparation& preparation) {
  describe(preparation, [](std::string_view key, std::uint64_t count) {
    require(count <= max_prepared, "{}={} exceeds the limit of a frame, {}; use a smaller model", key, count,
            max_prepared);
  });
}

void validate_preparations(const Program& program) {
  validate_preparation(*program.model_preparation);
  Preparation all = *program.preparation;
  validate_preparation(all);
  for (const Segment& segment : program.segments) {
    validate_preparation(*segment.preparation);
    all += *segment.preparation;
    validate_preparation(all);
  }
}

void validate_steps(const Segment& segment, const Program& program) {
  if (program.display_model.empty()) return;
  const std::uint64_t written = segment.division->sum().instructions;
  require(written == segment.instructions.size(),
          "its steps write {} instructions, but it has {}; compile the model again", written,
          segment.instructions.size());
}

void validate(const Program& program) {
  validate_header(program);
  std::set<std::string_view> names;
  for (const NamedField& named : program.facts->fields) {
    check_at([&] { validate_field(named, program); }, "field '{}'", named.name);
    require(names.insert(named.name).second, "field '{}' is named twice; give each field its own name", named.name);
  }
  for (const RowExtent& extent : program.extents) validate_extent(extent, program.shape);
  validate_preparations(program);
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    const Segment& segment = program.segments[s];
    check_at([&] { validate_region(segment.region, program.shape); }, "segment {}", s);
    require(!program.display_model.empty() || *segment.division == DivisionCounts{},
            "segment {} has division counts, but the Program has no display model; compile the model again", s);
    check_at([&] { validate_steps(segment, program); }, "segment {}", s);
    for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
      const auto check = [&] { validate_in_segment(segment.instructions[i], segment.region, program); };
      check_at(check, "segment {}, instruction {}", s, i);
    }
    for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
      if (!needs_lookahead(segment.instructions[i].opcode)) continue;
      check_at([&] { validate_with_successors(segment, i); }, "segment {}, instruction {}", s, i);
    }
  }
}

}  // namespace csgsim::isa
