#include "tests/support/random_program.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/colour_format.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/text.h"
#include "hw/machines/regions.h"

namespace csgsim::isa {

void showValue(const Program& program, std::ostream& out) {
  out << '\n';
  print(out, program);
}

}  // namespace csgsim::isa

namespace csgsim::test {

namespace {

using isa::Field;
using isa::FieldWidths;
using isa::Instruction;
using isa::Linear;
using isa::Opcode;
using isa::OpcodeInfo;
using isa::OperandKind;

/// Exceeds the capacity of the machine's link to the host.
constexpr unsigned most_skipped = 40;

/// Uniform random number from `least` to `most`, independent of rapidcheck's current size.
template <class Integer>
Integer pick(Integer least, Integer most) {
  return least + *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Integer>(0, most - least + 1));
}

/// Same as pick, but half of the time returns one of the preferred values in range.
unsigned pick_near(std::vector<unsigned> preferred, unsigned least, unsigned most) {
  std::erase_if(preferred, [=](unsigned value) { return value < least || value > most; });
  if (preferred.empty() || pick(0, 1) == 0) return pick(least, most);
  return *rc::gen::elementOf(preferred);
}

unsigned fields_of(const OpcodeInfo& row) {
  return static_cast<unsigned>(std::count_if(row.operands.begin(), row.operands.end(), isa::is_field));
}

/// Whether the opcode's fields fit in the memory.
bool fits(const OpcodeInfo& row, std::uint32_t memory_bits) {
  const FieldWidths widths = row.widths;
  if (widths == FieldWidths::odd) return memory_bits >= 3;
  return widths == FieldWidths::one || widths == FieldWidths::elementwise || fields_of(row) <= memory_bits;
}

/// Fields lie at or near multiples of a coarse grid, so that fields of different instructions often coincide or
/// overlap.
unsigned pick_base(unsigned room) { return std::min(room, pick(0U, room / 8U) * 8U + pick_near({0}, 0, 7)); }

/// Narrows the second field at either end or at both.
void pick_narrower(Field& second) {
  const unsigned width = pick_near({1, second.width / 2U, second.width}, 1, second.width);
  const unsigned base = second.base + pick(0U, second.width - width);
  second = {static_cast<std::uint16_t>(base), static_cast<std::uint16_t>(width)};
}

unsigned pick_width(FieldWidths widths, unsigned room) {
  constexpr unsigned most = isa::max_linear_width - 1;  // F needs one more
  switch (widths) {
    case FieldWidths::one: return 1;
    case FieldWidths::odd: return 1 + 2 * pick_near({1, 2, 15, 16, 30}, 1, (std::min(most, room) - 1) / 2);
    case FieldWidths::wide: return pick_near({1, 8, 20, 31, 32, 33, 41, most}, 1, std::min(most, room));
    case FieldWidths::free:
    case FieldWidths::equal:
    case FieldWidths::elementwise:
    case FieldWidths::narrower: break;
  }
  return pick_near({1, 2, 4, 8, 20, 31, 32}, 1, std::min(isa::max_field_width, room));
}

/// Picks disjoint fields in any order, equally wide unless one may be narrower. Operands that may coincide sometimes
/// share a field.
void pick_fields(Instruction& instruction, std::uint32_t memory_bits) {
  const OpcodeInfo& row = info(instruction.opcode);
  const unsigned count = fields_of(row);
  if (count == 0) return;
  const FieldWidths widths = row.widths;
  const bool coincide = widths == FieldWidths::elementwise;
  const unsigned places = coincide ? pick(1U, std::min(count, memory_bits)) : count;
  const unsigned width = pick_width(widths, memory_bits / places);
  unsigned room = memory_bits - places * width;
  unsigned base = 0;
  std::array<Field, isa::max_operands> placed;
  for (unsigned i = 0; i < places; ++i) {
    const unsigned gap = pick_base(room);
    placed[i] = Field{static_cast<std::uint16_t>(base + gap), static_cast<std::uint16_t>(width)};
    room -= gap;
    base += gap + width;
  }
  if (pick(0, 1) == 1) std::reverse(placed.begin(), placed.begin() + places);
  for (unsigned i = 0; i < count; ++i) instruction.fields[i] = placed[coincide ? pick(0U, places - 1) : i];
  if (widths == FieldWidths::narrower) pick_narrower(instruction.fields[1]);
}

/// A coefficient of either sign, at most `most` in magnitude.
std::int64_t pick_coefficient(std::int64_t most) {
  switch (pick(0, 5)) {
    case 0: return 0;
    case 1: return most;
    case 2: return -most;
    case 3: return pick<std::int64_t>(-std::min<std::int64_t>(most, 3), std::min<std::int64_t>(most, 3));
    default: return pick<std::int64_t>(-most, most);
  }
}

/// Keeps the sum below 2^bits in magnitude and small at some pixel, so that tests separate the pixels.
void pick_coefficients(Linear& linear, unsigned bits, isa::ArrayShape region) {
  const std::int64_t share = ((std::int64_t{1} << bits) - 1) / 5;
  linear.a = pick_coefficient(share / region.width);
  linear.b = pick_coefficient(share / region.height);
  const std::int64_t x = pick(0U, region.width - 1);
  const std::int64_t y = pick(0U, region.height - 1);
  linear.c = pick_coefficient(share) - linear.a * x - linear.b * y;
}

/// Magnitudes of the sum in bits: the field's range, the full width, or the limit of the widest width. A sum that is
/// meant to overflow gets a few bits more than its width instead of the first choice.
std::array<unsigned, 3> reaches_of(const Instruction& instruction) {
  const Linear& linear = instruction.linear;
  const unsigned held = linear.width - 1U;
  const unsigned of_field = std::min(instruction.fields[0].width + linear.shift + 1U, held);
  const unsigned cut = std::min(linear.width + 3U, isa::max_linear_width);
  return {isa::may_exceed_width(instruction.opcode) ? cut : of_field, held, isa::max_linear_width};
}

void pick_linear(Instruction& instruction, isa::ArrayShape region) {
  const unsigned met = instruction.fields[0].width;
  const unsigned least = met + 1;
  Linear& linear = instruction.linear;
  const unsigned kept = pick_near({least, least + 1, least + 4, isa::max_linear_width}, least, isa::max_linear_width);
  const unsigned shift = pick_near({0, 1, 12, isa::max_linear_width - kept}, 0, isa::max_linear_width - kept);
  linear.width = static_cast<std::uint16_t>(kept + shift);
  linear.shift = static_cast<std::uint16_t>(shift);
  pick_coefficients(linear, reaches_of(instruction).at(std::min(2U, pick(0U, 9U) / 4U)), region);
}

/// Limits |A|, |B| and |C| so that the squares stay below `most`.
void pick_squares(Linear& squares, std::int64_t most, const isa::ArrayShape& region) {
  const std::int64_t share = most / 3;
  squares.a = pick_coefficient(share / region.width / region.width);
  squares.b = pick_coefficient(share / region.width / region.height);
  squares.c = pick_coefficient(share / region.height / region.height);
}

/// Squares for a linear instruction, which is adjusted so that the sum stays in range and is nearly unchanged at some
/// pixel.
Instruction pick_squares_before(Instruction& instruction, const isa::ArrayShape& region) {
  Linear& linear = instruction.linear;
  for (std::int64_t* const coefficient : {&linear.a, &linear.b, &linear.c}) *coefficient /= 2;
  Instruction squares{Opcode::squares, {}, {}, 0, instruction.origin};
  squares.linear.width = linear.width;
  const unsigned bits = std::min(
      59U, pick_near({linear.width - 1U, instruction.fields[0].width + linear.shift + 0U}, 0, linear.width - 1U));
  pick_squares(squares.linear, std::int64_t{1} << bits, region);
  const std::int64_t x = pick(0U, region.width - 1);
  const std::int64_t y = pick(0U, region.height - 1);
  const Linear& s = squares.linear;
  linear.c -= s.a * x * x + s.b * x * y + s.c * y * y;
  return squares;
}

std::uint64_t pick_constant(unsigned width) {
  const std::uint64_t ones = (std::uint64_t{1} << width) - 1;
  switch (pick(0, 3)) {
    case 0: return 0;
    case 1: return ones;
    case 2: return ones / 2 + 1;
    default: return pick<std::uint64_t>(0, ones);
  }
}

isa::Origin pick_origin(std::uint32_t primitives) {
  isa::Origin origin;
  origin.purpose = static_cast<isa::Purpose>(pick<std::size_t>(0, isa::purpose_table.size() - 1));
  const auto pick_index = [&](std::uint32_t none) {
    const std::uint32_t index = pick(0U, primitives);
    return index == primitives ? none : index;
  };
  origin.primitive = pick_index(isa::no_primitive);
  origin.node = pick_index(isa::no_node);
  return origin;
}

/// Picks any opcode; those that enable pixels, make patterns of enabled pixels, or skip are more frequent.
Opcode pick_opcode(std::uint32_t memory_bits, unsigned degree) {
  switch (pick(0, 19)) {
    case 0: return Opcode::enable_all;
    case 1: return Opcode::enable_invert;
    case 2: return Opcode::edge_not_negative;
    case 3: return Opcode::edge_negative;
    case 4: return Opcode::load_linear;
    case 5: return Opcode::skip_if_none;
    default: break;
  }
  std::vector<Opcode> opcodes;
  for (const OpcodeInfo& row : isa::opcode_table)
    if (fits(row, memory_bits) && (degree > 1 || row.opcode != Opcode::squares)) opcodes.push_back(row.opcode);
  return *rc::gen::elementOf(opcodes);
}

/// The whole array half of the time, otherwise a part of it.
isa::Region pick_region(isa::ArrayShape shape) {
  if (pick(0, 1) == 0) return {0, 0, shape.width, shape.height};
  isa::Region region;
  region.width = pick(1U, shape.width);
  region.height = pick(1U, shape.height);
  region.x = pick(0U, shape.width - region.width);
  region.y = pick(0U, shape.height - region.height);
  return region;
}

/// Whether the instruction can only disable pixels.
bool narrows(Opcode opcode) {
  const std::string_view meaning = info(opcode).meaning;
  return meaning.find("E := E and") != meaning.npos || meaning.find("E := 0") != meaning.npos;
}

/// Enables all pixels again before a third instruction that can only disable some.
std::vector<Instruction> with_enable_all(const std::vector<Instruction>& instructions) {
  std::vector<Instruction> out;
  int narrowed = 3;
  for (const Instruction& instruction : instructions) {
    if (narrows(instruction.opcode) && ++narrowed > 2) {
      out.push_back({Opcode::enable_all, {}, {}, 0, instruction.origin});
      narrowed = 1;
    }
    if (instruction.opcode == Opcode::enable_all) narrowed = 0;
    out.push_back(instruction);
  }
  return out;
}

/// Inserts squares before a third of the instructions that can follow squares.
std::vector<Instruction> with_squares(std::vector<Instruction> instructions, const isa::ArrayShape& region) {
  std::vector<Instruction> out;
  for (Instruction& instruction : instructions) {
    if (isa::has_operand(operands_of(instruction.opcode), OperandKind::linear) && pick(0, 2) == 0)
      out.push_back(pick_squares_before(instruction, region));
    out.push_back(instruction);
  }
  return out;
}

bool is_squares(const Instruction& instruction) { return instruction.opcode == Opcode::squares; }

/// Skips end within the segment and never at squares; a skip at the end of a segment only performs its test.
void fit_skips(std::vector<Instruction>& instructions) {
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    Instruction& instruction = instructions[i];
    if (!isa::has_operand(operands_of(instruction.opcode), OperandKind::count)) continue;
    const std::size_t following = instructions.size() - 1 - i;
    if (following == 0) instruction = {Opcode::global_or, {}, {}, 0, instruction.origin};
    instruction.constant = std::min<std::uint64_t>(instruction.constant, following);
    if (following > 0 && is_squares(instructions[i + instruction.constant])) ++instruction.constant;
  }
}

std::vector<Instruction> pick_instructions(const isa::Region& region, std::uint32_t memory_bits,
                                           std::size_t max_instructions, std::uint32_t primitives, unsigned degree) {
  const isa::ArrayShape shape{region.width, region.height, memory_bits};
  std::vector<Instruction> instructions = with_enable_all(*rc::gen::resize(
      static_cast<int>(max_instructions),
      rc::gen::container<std::vector<Instruction>>(arbitrary_instruction(shape, memory_bits, primitives))));
  if (degree > 1) instructions = with_squares(std::move(instructions), shape);
  instructions.resize(std::min(instructions.size(), max_instructions));
  if (!instructions.empty() && is_squares(instructions.back())) instructions.pop_back();
  fit_skips(instructions);
  return instructions;
}

isa::Segment pick_segment(const isa::Region& region, std::uint32_t memory_bits, std::size_t max_instructions,
                          std::uint32_t primitives, unsigned degree) {
  isa::Segment segment;
  segment.region = region;
  segment.facts->primitives = pick(0U, primitives);
  segment.facts->halfspaces = segment.facts->primitives * 6;
  segment.instructions = pick_instructions(region, memory_bits, max_instructions, primitives, degree);
  return segment;
}

/// Arbitrary bytes, for names.
std::string pick_name() {
  return *rc::gen::resize(
      12, rc::gen::container<std::string>(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<char>())));
}

double pick_positive() {
  return static_cast<double>(pick<std::uint64_t>(1, 1ULL << 53U)) / static_cast<double>(pick<std::uint64_t>(1, 999));
}

void pick_facts(isa::Program& program) {
  program.facts->depth_scale.perspective = pick(0, 1) == 1;
  program.facts->depth_scale.near = pick_positive();
  program.facts->depth_scale.far = program.facts->depth_scale.near + pick_positive() + program.facts->depth_scale.near;
  program.facts->model = {pick_name(), pick<std::uint64_t>(0, ~0ULL >> 1U), 2, 3, 4, 5};
  program.facts->compile.strategy = pick_name();
  program.facts->compile.z_bits = pick(0U, 32U);
  program.facts->compile.edge_on_fraction = 1 / pick_positive();
  program.facts->compile.depth_tests = pick<std::uint64_t>(0, 1ULL << 40U);
  while (pick(0, 1) == 1) program.facts->compile.effects.push_back(pick_name());
}

/// Each name is unique because it begins with its number.
void pick_names(isa::Program& program) {
  const unsigned fields = pick(0U, 4U);
  for (unsigned i = 0; i < fields; ++i) {
    const unsigned width = pick_near({1, 8, 32}, 1, std::min(isa::max_field_width, program.shape.memory_bits));
    const unsigned base = pick_base(program.shape.memory_bits - width);
    const auto role = static_cast<isa::FieldRole>(pick<std::size_t>(0, isa::field_role_names.size() - 1));
    std::string name(pick(0U, 1U), 'x');
    name += std::to_string(i);
    if (pick(0, 1) == 1) name += pick_name();
    isa::Field field{static_cast<std::uint16_t>(base), static_cast<std::uint16_t>(width)};
    if (role == isa::FieldRole::colour && program.colour.width > 0) field = program.colour;
    if (role == isa::FieldRole::colour) program.colour = field;
    program.facts->fields.push_back({name, field, role});
  }
  const unsigned primitives = pick(0U, 4U);
  for (unsigned i = 0; i < primitives; ++i) program.facts->primitives.push_back(pick_name());
}

/// Extents are independent of the instructions because machines use only the declared values.
void pick_extents(isa::Program& program) {
  const unsigned extents = pick(0U, 1U) * pick(0U, 6U);
  for (unsigned i = 0; i < extents; ++i) {
    const auto first = static_cast<std::uint16_t>(pick(0U, program.shape.height - 1));
    const auto last = static_cast<std::uint16_t>(pick<unsigned>(first, program.shape.height - 1));
    program.extents.push_back({first, last});
  }
}

void pick_machine(isa::Program& program) {
  if (pick(0, 1) == 0) return;
  program.machine = {pick_name(), pick_name(), {}};
  while (pick(0, 1) == 1) program.machine.figures.push_back(pick_name());
}

}  // namespace

rc::Gen<isa::Instruction> arbitrary_instruction(isa::ArrayShape region, std::uint32_t memory_bits,
                                                std::uint32_t primitives, unsigned degree) {
  return rc::gen::exec([=] {
    Instruction instruction;
    instruction.opcode = pick_opcode(memory_bits, degree);
    instruction.origin = pick_origin(primitives);
    pick_fields(instruction, memory_bits);
    const OpcodeInfo& row = info(instruction.opcode);
    if (isa::has_operand(row.operands, OperandKind::linear)) pick_linear(instruction, region);
    if (isa::has_operand(row.operands, OperandKind::squares)) {
      instruction.linear.width = static_cast<std::uint16_t>(pick(1U, isa::max_linear_width));
      pick_squares(instruction.linear, std::int64_t{1} << instruction.linear.width, region);
    }
    if (isa::has_operand(row.operands, OperandKind::constant))
      instruction.constant = pick_constant(instruction.fields[0].width);
    if (isa::has_operand(row.operands, OperandKind::count))
      instruction.constant = pick_near({1, 2, 3}, 1, most_skipped);
    return instruction;
  });
}

namespace {

/// Random tests with `instructions` instructions in total between them.
std::vector<isa::DivisionStep> pick_steps(std::size_t instructions) {
  std::vector<isa::DivisionStep> steps;
  std::size_t left = instructions;
  const std::uint32_t more = pick(0U, 3U);
  for (std::uint32_t i = 0; i <= more; ++i) {
    const std::size_t written = i == more ? left : pick(std::size_t{0}, left);
    left -= written;
    const std::uint32_t lists = pick(0U, 2U);
    steps.push_back({.boxes = pick(0U, 9U),
                     .lists = lists,
                     .halfspaces = lists == 0 ? 0 : lists + pick(0U, 9U),
                     .cells = pick(0U, 9U),
                     .nodes = pick(0U, 9U),
                     .instructions = written});
  }
  return steps;
}

isa::Preparation pick_preparation() {
  return {.planes = pick(0U, 9U),
          .points = pick(0U, 9U),
          .colours = pick(0U, 9U),
          .boxes = pick(0U, 9U),
          .halfspaces = pick(0U, 9U),
          .values = pick(0U, 9U),
          .supports = pick(0U, 9U),
          .nodes = pick(0U, 9U),
          .products = pick(0U, 9U),
          .quotients = pick(0U, 9U)};
}

isa::PruningFacts pick_pruning() {
  return {.name = pick(0U, 1U) == 0 ? "space" : "hidden",
          .tried = pick(0U, 9U),
          .decided = pick(0U, 9U),
          .left = pick(0U, 9U),
          .saved = pick(0U, 9U),
          .nanoseconds = pick(0U, 9U)};
}

/// Work of the host; often none.
void pick_preparations(isa::Program& program) {
  if (pick(0U, 1U) == 0) return;
  *program.preparation = pick_preparation();
  *program.model_preparation = pick_preparation();
  for (unsigned left = pick(0U, 2U); left > 0; --left) program.facts->prunings.push_back(pick_pruning());
  for (isa::Segment& segment : program.segments) *segment.preparation = pick_preparation();
}

/// Arbitrary bytes as a display model, together with the work of its division; often neither.
void pick_division(isa::Program& program) {
  program.display_model.resize(pick(0U, 1U) * pick(0U, 120U));
  for (std::uint8_t& byte : program.display_model) byte = static_cast<std::uint8_t>(pick(0U, 255U));
  if (program.display_model.empty()) return;
  for (isa::Segment& segment : program.segments) {
    *segment.division = {.steps = pick_steps(segment.instructions.size()),
                         .group_boxes = pick(0U, 9U),
                         .group_lists = pick(0U, 9U),
                         .group_halfspaces = pick(0U, 99U),
                         .group_cells = pick(0U, 9U),
                         .group_entries = pick(0U, 9U)};
  }
}

}  // namespace

rc::Gen<isa::Program> arbitrary_program(isa::ArrayShape shape, std::size_t max_instructions, unsigned degree) {
  return rc::gen::exec([=] {
    isa::Program program;
    program.shape = shape;
    pick_facts(program);
    pick_names(program);
    pick_extents(program);
    pick_machine(program);
    const int segments = pick(1, 3);
    const auto primitives = static_cast<std::uint32_t>(program.facts->primitives.size());
    for (int i = 0; i < segments; ++i) {
      program.segments.push_back(
          pick_segment(pick_region(shape), shape.memory_bits, max_instructions, primitives, degree));
    }
    pick_division(program);
    pick_preparations(program);
    return program;
  });
}

void erase_queries(std::vector<Instruction>& instructions) {
  std::erase_if(instructions, [](const Instruction& instruction) { return isa::needs_global_or(instruction.opcode); });
}

rc::Gen<isa::Program> arbitrary_program_in_parts(const machines::Machine& machine, std::size_t max_instructions,
                                                 unsigned degree) {
  return rc::gen::exec([=] {
    isa::Program program;
    program.shape = {machine.picture.width, machine.picture.height, machine.array.memory_bits};
    pick_facts(program);
    pick_names(program);
    pick_extents(program);
    program.facts->model.primitives = pick(0U, 4U);
    program.facts->model.halfspaces = pick(0U, 30U);
    const unsigned colour_bits = program.colour.width;
    program.background = pick(0U, (1U << std::min(colour_bits, isa::max_colour_bits)) - 1);
    const auto primitives = static_cast<std::uint32_t>(program.facts->primitives.size());
    const unsigned without = std::min(pick(0U, 12U), 10U);  // out of ten segments
    for (const isa::Region& region : machines::regions(machine)) {
      program.segments.push_back(pick_segment(region, program.shape.memory_bits, max_instructions, primitives, degree));
      std::vector<Instruction>& instructions = program.segments.back().instructions;
      if (machines::has_global_or(machine)) {
        for (Instruction& instruction : instructions)
          if (instruction.opcode == Opcode::global_or)
            instruction = {Opcode::enable_invert, {}, {}, 0, instruction.origin};
      } else {
        erase_queries(instructions);
      }
      if (pick(0U, 9U) < without) instructions.clear();
    }
    return program;
  });
}

}  // namespace csgsim::test
