#include "hw/multi_processor/prices.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/wire.h"

namespace csgsim::multi_processor {

namespace {

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

/// The fields that an instruction reads and writes; it writes E if it may change it.
Work field_work(const isa::Instruction& instruction, const Figures& figures) {
  const isa::OpcodeInfo& row = isa::info(instruction.opcode);
  Work work{.writes = row.enable_effect == isa::EnableEffect::keeps ? 0U : 1U};
  for (std::size_t i = 0; i < row.operands.size(); ++i) {
    if (!isa::is_field(row.operands[i])) continue;
    const std::uint64_t words = words_of(instruction.fields[i].width, figures);
    const bool is_target = row.operands[i] == isa::OperandKind::target;
    if (is_target) work.writes += words;
    if (!is_target || isa::reads_target(instruction.opcode)) work.reads += words;
  }
  return work;
}

/// Adds the trials of a root.
void add_trials(const isa::Instruction& instruction, const Figures& figures, Work& work) {
  for (unsigned found = 0; found < instruction.fields[0].width / 2U; ++found) {
    const std::uint64_t words = words_of(found + 3, figures);
    work.compares += words;
    work.combines += 2 * words;
    work.adds += words;
    work.shifts += 2 * shift_clocks(found + 3, 2, figures);
  }
}

/// Adds the comparison or sum of F with a field; the sign of F alone is one word.
void add_linear_work(const isa::Instruction& instruction, const Figures& figures, Work& work) {
  const isa::OpcodeInfo& row = isa::info(instruction.opcode);
  const std::uint64_t sum = words_of(instruction.linear.width, figures);
  const std::uint64_t wider = std::max(words_of(instruction.fields[0].width, figures), sum);
  if (row.operands[0] == isa::OperandKind::linear) {
    work.compares = 1;
  } else if (row.enable_effect == isa::EnableEffect::keeps) {
    work.adds = sum;
  } else {
    const bool writes = row.operands[0] == isa::OperandKind::target;  // F is written if it fits
    work.compares = (work.reads > 0 ? wider : 0) + (writes ? sum : 0);
  }
}

/// The work of an instruction, by its columns in the table of the instruction set.
Work work_of(const isa::Instruction& instruction, const Figures& figures) {
  const isa::OpcodeInfo& row = isa::info(instruction.opcode);
  const std::uint64_t field = words_of(instruction.fields[0].width, figures);
  const bool has_constant = isa::has_operand(row.operands, isa::OperandKind::constant);
  Work work = field_work(instruction, figures);
  if (row.clock_class == isa::ClockClass::root) {
    add_trials(instruction, figures, work);
  } else if (isa::has_operand(row.operands, isa::OperandKind::linear)) {
    add_linear_work(instruction, figures, work);
  } else if (row.widths == isa::FieldWidths::narrower) {
    work.adds = field;
  } else if (row.widths == isa::FieldWidths::elementwise || (has_constant && work.reads > 0)) {
    work.combines = field;
  } else if (row.clock_class == isa::ClockClass::two_fields) {
    work.compares = field;
  }
  return work;
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
  const bool selects = isa::info(instruction.opcode).clock_class == isa::ClockClass::linear_twice;
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
