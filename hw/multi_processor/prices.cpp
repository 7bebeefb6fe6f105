#include "hw/multi_processor/prices.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"

namespace csgsim::multi_processor {

namespace {

using isa::Opcode;

/// Operations of an instruction at a pixel, in words, without testing E and incrementing F.
struct Work {
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
  std::uint64_t compares = 0;
  std::uint64_t combines = 0;
  std::uint64_t adds = 0;
  std::uint64_t shifts = 0;  ///< clocks
};

std::uint64_t words_of(std::uint64_t bits, const Figures& figures) { return quotient_up(bits, figures.word_bits); }

std::uint64_t shift_clocks(std::uint64_t places, const OperationClocks& each) {
  return each.shift + places * each.shift_bit;
}

/// Clocks to shift a number of `bits` bits.
std::uint64_t shift_clocks(std::uint64_t bits, std::uint64_t places, const Figures& figures) {
  const std::uint64_t rest = places % figures.word_bits;
  if (rest == 0) return 0;
  const std::uint64_t words = words_of(bits, figures);
  const std::uint64_t left = words - std::min(words - 1, places / figures.word_bits);
  return left * shift_clocks(rest, figures.operations) +
         (left - 1) * (shift_clocks(figures.word_bits - rest, figures.operations) + figures.operations.logic);
}

Work work_of(const isa::Instruction& instruction, const Figures& figures) {
  const std::uint64_t field = words_of(instruction.fields[0].width, figures);
  const std::uint64_t sum = words_of(instruction.linear.width, figures);
  const std::uint64_t wider = std::max(field, sum);
  switch (instruction.opcode) {
    case Opcode::enable_all:
    case Opcode::enable_invert: return {.writes = 1};
    case Opcode::enable_load:
    case Opcode::enable_and:
    case Opcode::enable_and_not:
    case Opcode::enable_or:
    case Opcode::enable_xor: return {.reads = field, .writes = 1};
    case Opcode::enable_store: return {.writes = field};
    case Opcode::edge_not_negative:
    case Opcode::edge_negative:
    case Opcode::stripe: return {.writes = 1, .compares = 1};
    case Opcode::linear_ge:
    case Opcode::linear_gt:
    case Opcode::linear_le:
    case Opcode::linear_lt:
    case Opcode::linear_eq: return {.reads = field, .writes = 1, .compares = wider};
    case Opcode::load_linear: return {.writes = field + 1, .compares = sum};
    case Opcode::keep_max:
    case Opcode::keep_min: return {.reads = field, .writes = field + 1, .compares = wider + sum};
    case Opcode::set_constant: return {.writes = field};
    case Opcode::copy: return {.reads = field, .writes = field};
    case Opcode::field_lt:
    case Opcode::field_le:
    case Opcode::field_eq: return {.reads = 2 * field, .writes = 1, .compares = field};
    case Opcode::bit_and:
    case Opcode::bit_or:
    case Opcode::bit_xor:
    case Opcode::bit_and_not: return {.reads = 2 * field, .writes = field, .combines = field};
    case Opcode::bit_not:
    case Opcode::xor_constant: return {.reads = field, .writes = field, .combines = field};
    case Opcode::add:
      return {.reads = field + words_of(instruction.fields[1].width, figures), .writes = field, .adds = field};
    case Opcode::global_or:
    case Opcode::skip_if_none: return {};
    case Opcode::linear_plus:
    case Opcode::linear_minus: return {.reads = field, .writes = field, .adds = sum};
    case Opcode::root: {
      std::uint64_t trials = 0;
      std::uint64_t shifts = 0;
      for (unsigned found = 0; found < instruction.fields[0].width / 2U; ++found) {
        trials += words_of(found + 3, figures);
        shifts += 2 * shift_clocks(found + 3, 2, figures);
      }
      return {.reads = field,
              .writes = field,
              .compares = trials,
              .combines = 2 * trials,
              .adds = trials,
              .shifts = shifts};
    }
    case Opcode::squares: return {};  // rejected by the kind
  }
  return {};
}

/// Clocks to compute A*x + B*y + C and `products` more products.
std::uint64_t sum_clocks(const isa::Instruction& instruction, std::uint64_t products, const Figures& figures) {
  const std::uint64_t words = words_of(instruction.linear.width, figures);
  return words * ((2 + products) * figures.operations.multiply + 2 * figures.operations.add);
}

std::uint64_t add_clocks(const isa::Instruction& instruction, const Figures& figures) {
  return words_of(instruction.linear.width, figures) * figures.operations.add;
}

/// Widths of the numbers of an instruction in a list of that form: the five numbers of its expression, which come last,
/// are preceded by a flag bit; or they are replaced by a flag bit, an index and a width.
std::vector<std::uint8_t> written_widths(const isa::Instruction& instruction, const ListForm& form) {
  const isa::WireFields fields(instruction);
  std::vector<std::uint8_t> numbers(fields.widths().begin(), fields.widths().end());
  if (!form.has_numbers || instruction.linear.width == 0) return numbers;
  const auto expression = numbers.end() - 5;
  if (!uses_index(instruction, form)) {
    numbers.insert(expression, 1);
    return numbers;
  }
  numbers.erase(expression, numbers.end());
  for (const unsigned width : {1U, form.number_bits, number_width_bits})
    numbers.push_back(static_cast<std::uint8_t>(width));
  return numbers;
}

/// Clocks to fetch an instruction; for a half-space's index, its expression is computed from the half-space's record.
std::uint64_t fetch_clocks(const isa::Instruction& instruction, const ListForm& form, const Figures& figures) {
  const std::uint64_t read = figures.loop.instruction +
                             words_of(written_bits(instruction, form), figures) * figures.operations.read +
                             unpacking_clocks(written_widths(instruction, form), figures);
  if (!uses_index(instruction, form)) return read;
  return read + words_of(form.record_bits, figures) * figures.operations.read +
         unpacking_clocks(form.record_numbers, figures) + figures.node_tests.instruction;
}

/// Words of the operands, each starting at a word.
std::uint64_t operand_words(const isa::Instruction& instruction, const Figures& figures) {
  const isa::WireFields fields(instruction);
  std::uint64_t words = 0;
  for (std::size_t i = 1; i < fields.widths().size(); ++i) words += words_of(fields.widths()[i], figures);
  return words;
}

/// Clocks to fetch an instruction from the list.
std::uint64_t reach_clocks(const isa::Instruction& instruction, const ListForm& form, const Figures& figures) {
  if (figures.chain.program == NodeProgram::interpreted) return fetch_clocks(instruction, form, figures);
  return figures.chain.call + operand_words(instruction, figures) * figures.operations.read;
}

/// Clocks to translate an instruction of a list to a call of a native program.
std::uint64_t link_clocks(const isa::Instruction& instruction, const ListForm& form, const Figures& figures) {
  if (figures.chain.program == NodeProgram::interpreted) return 0;
  return fetch_clocks(instruction, form, figures) + figures.chain.link +
         operand_words(instruction, figures) * figures.operations.write;
}

}  // namespace

std::uint64_t written_bits(const isa::Command& command, const ListForm& form) {
  const auto* const instruction = std::get_if<isa::Instruction>(&command);
  const std::uint64_t bits = isa::wire_bits(command);
  if (instruction == nullptr || !form.has_numbers || instruction->linear.width == 0) return bits;
  if (!uses_index(*instruction, form)) return bits + 1;
  const std::uint64_t expression =
      isa::wire_linear_width_bits + isa::wire_shift_bits + 3 * std::uint64_t{instruction->linear.width};
  return bits - expression + 1 + form.number_bits + number_width_bits;
}

std::uint64_t unpacking_clocks(std::span<const std::uint8_t> widths, const Figures& figures) {
  if (figures.field_clocks == unpacked) return 0;
  const std::uint64_t word = figures.word_bits;
  std::uint64_t clocks = 0;
  std::uint64_t begin = 0;
  for (const std::uint8_t width : widths) {
    const std::uint64_t place = begin % word;
    clocks += figures.field_clocks;
    if (width % word != 0) clocks += figures.operations.logic;
    if (place > 0) {
      clocks += words_of(width, figures) * shift_clocks(place, figures.operations);
      clocks +=
          ((place + width - 1) / word) * (shift_clocks(word - place, figures.operations) + figures.operations.logic);
    }
    begin += width;
  }
  return clocks;
}

PixelCosts pixel_costs(const isa::Instruction& instruction, const Figures& figures) {
  const OperationClocks& operations = figures.operations;
  const BranchFigures& branches = figures.branches;
  const Work work = work_of(instruction, figures);
  const isa::Linear& linear = instruction.linear;
  const std::uint64_t test_e = std::uint64_t{operations.read} + operations.logic;
  const std::uint64_t shift = linear.width > 0 ? shift_clocks(linear.width, linear.shift, figures) : 0;
  const bool by_pixel = figures.order == RenderingOrder::pixel;
  const std::uint64_t start = by_pixel ? sum_clocks(instruction, 0, figures) : 0;
  const std::uint64_t increment = by_pixel ? 0 : add_clocks(instruction, figures);
  const std::uint64_t reads = work.reads * operations.read;
  const std::uint64_t full = test_e + start + reads + work.writes * operations.write +
                             work.compares * operations.compare + work.combines * operations.logic +
                             work.adds * operations.add + work.shifts + shift + increment;
  if (branches.over == Branches::none || isa::acts_on_disabled(instruction.opcode)) return {full, full, full};
  const std::uint64_t disabled = test_e + branches.taken + increment;
  const bool selects = instruction.opcode == Opcode::keep_max || instruction.opcode == Opcode::keep_min;
  if (!selects) return {disabled, full + branches.passed, full + branches.passed};
  const std::uint64_t wider = words_of(std::max<std::uint64_t>(linear.width, instruction.fields[0].width), figures);
  return {disabled,
          test_e + branches.passed + start + reads + wider * operations.compare + shift + branches.taken + increment,
          full + 2 * std::uint64_t{branches.passed}};
}

InstructionCosts instruction_costs(const isa::Instruction& instruction, const ListForm& form, const Figures& figures) {
  const std::uint64_t reach = reach_clocks(instruction, form, figures);
  const std::uint64_t sum = sum_clocks(instruction, 2, figures);
  InstructionCosts costs{.at_pixel = pixel_costs(instruction, figures),
                         .link = link_clocks(instruction, form, figures),
                         .reach = reach,
                         .sum = sum};
  switch (figures.order) {
    case RenderingOrder::segment:
      costs.once = reach + sum;
      costs.row = add_clocks(instruction, figures) + figures.loop.row;
      costs.pixel = figures.loop.pixel;
      break;
    case RenderingOrder::scan_line:
      costs.row = reach + sum_clocks(instruction, 1, figures);
      costs.pixel = figures.loop.pixel;
      break;
    case RenderingOrder::pixel: costs.pixel = reach; break;
  }
  return costs;
}

}  // namespace csgsim::multi_processor
