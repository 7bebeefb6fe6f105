#include "hw/multi_processor/clocks.h"

#include <algorithm>
#include <bit>
#include <variant>
#include <vector>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

namespace {

using isa::Opcode;
using machines::Machine;

/// What an instruction does at a pixel besides looking at E and adding to F, in words.
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

/// Of a number of so many bits.
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
    case Opcode::squares: return {};  // which the kind does not take
  }
  return {};
}

/// A*x + B*y + C with so many products more beside it.
std::uint64_t sum_clocks(const isa::Instruction& instruction, std::uint64_t products, const Figures& figures) {
  const std::uint64_t words = words_of(instruction.linear.width, figures);
  return words * ((2 + products) * figures.operations.multiply + 2 * figures.operations.add);
}

std::uint64_t add_clocks(const isa::Instruction& instruction, const Figures& figures) {
  return words_of(instruction.linear.width, figures) * figures.operations.add;
}

/// Of an instruction in a list of that form: the five numbers of its expression, which are its last, have a bit before
/// them; or there are a number and a width in their place.
std::vector<std::uint8_t> written_numbers(const isa::Instruction& instruction, const ListForm& form) {
  const isa::WireFields fields(instruction);
  std::vector<std::uint8_t> numbers(fields.widths().begin(), fields.widths().end());
  if (!form.has_numbers || instruction.linear.width == 0) return numbers;
  const auto expression = numbers.end() - 5;
  if (!is_named(instruction, form)) {
    numbers.insert(expression, 1);
    return numbers;
  }
  numbers.erase(expression, numbers.end());
  for (const unsigned width : {1U, form.number_bits, number_width_bits})
    numbers.push_back(static_cast<std::uint8_t>(width));
  return numbers;
}

/// The expression of a half-space whose number came is worked out.
std::uint64_t fetch_clocks(const isa::Instruction& instruction, const ListForm& form, const Figures& figures) {
  const std::uint64_t read = figures.loop.instruction +
                             words_of(written_bits(instruction, form), figures) * figures.operations.read +
                             unpacking_clocks(written_numbers(instruction, form), figures);
  if (!is_named(instruction, form)) return read;
  return read + words_of(form.record_bits, figures) * figures.operations.read +
         unpacking_clocks(form.record_numbers, figures) + figures.node_tests.instruction;
}

/// Words of the numbers beside the opcode, if each begins at a word.
std::uint64_t operand_words(const isa::Instruction& instruction, const Figures& figures) {
  const isa::WireFields fields(instruction);
  std::uint64_t words = 0;
  for (std::size_t i = 1; i < fields.widths().size(); ++i) words += words_of(fields.widths()[i], figures);
  return words;
}

/// To come to an instruction of the list.
std::uint64_t reach_clocks(const isa::Instruction& instruction, const ListForm& form, const Figures& figures) {
  if (figures.chain.program == NodeProgram::interpreted) return fetch_clocks(instruction, form, figures);
  return figures.chain.call + operand_words(instruction, figures) * figures.operations.read;
}

/// To make a list a native program.
std::uint64_t chain_clocks(std::span<const isa::Instruction> list, const ListForm& form, const Figures& figures) {
  if (figures.chain.program == NodeProgram::interpreted) return 0;
  std::uint64_t clocks = 0;
  for (const isa::Instruction& instruction : list) {
    clocks += fetch_clocks(instruction, form, figures) + figures.chain.link +
              operand_words(instruction, figures) * figures.operations.write;
  }
  return clocks;
}

/// Loops over the pixels around something that is done at each.
std::uint64_t pass_clocks(const NodePixels& own, std::uint64_t at_each, const Figures& figures) {
  return own.count() * (at_each + figures.loop.pixel) + own.rows * std::uint64_t{figures.loop.row};
}

/// What goes round all instructions.
std::uint64_t outer_clocks(const NodePixels& own, const Figures& figures) {
  switch (figures.order) {
    case RenderingOrder::segment: return 0;
    case RenderingOrder::scan_line: return own.rows * std::uint64_t{figures.loop.row};
    case RenderingOrder::pixel: return pass_clocks(own, 0, figures);
  }
  return 0;
}

/// Clocks of an instruction at a pixel, by how much of it is carried out there.
struct Prices {
  std::uint64_t disabled = 0;  ///< where it has no effect, since E is 0
  std::uint64_t unchosen = 0;  ///< where E is 1 and it keeps what is there
  std::uint64_t whole = 0;

  [[nodiscard]] std::uint64_t most() const { return std::max({disabled, unchosen, whole}); }
};

Prices prices_of(const isa::Instruction& instruction, const Figures& figures) {
  const OperationClocks& operations = figures.operations;
  const BranchFigures& branches = figures.branches;
  const Work work = work_of(instruction, figures);
  const isa::Linear& linear = instruction.linear;
  const std::uint64_t look = std::uint64_t{operations.read} + operations.logic;
  const std::uint64_t shift = linear.width > 0 ? shift_clocks(linear.width, linear.shift, figures) : 0;
  const bool by_pixel = figures.order == RenderingOrder::pixel;
  const std::uint64_t start = by_pixel ? sum_clocks(instruction, 0, figures) : 0;
  const std::uint64_t go_on = by_pixel ? 0 : add_clocks(instruction, figures);
  const std::uint64_t reads = work.reads * operations.read;
  const std::uint64_t whole = look + start + reads + work.writes * operations.write +
                              work.compares * operations.compare + work.combines * operations.logic +
                              work.adds * operations.add + work.shifts + shift + go_on;
  if (branches.over == Branches::none || isa::acts_on_disabled(instruction.opcode)) return {whole, whole, whole};
  const std::uint64_t disabled = look + branches.taken + go_on;
  const bool chooses = instruction.opcode == Opcode::keep_max || instruction.opcode == Opcode::keep_min;
  if (!chooses) return {disabled, whole + branches.passed, whole + branches.passed};
  const std::uint64_t wider = words_of(std::max<std::uint64_t>(linear.width, instruction.fields[0].width), figures);
  return {disabled,
          look + branches.passed + start + reads + wider * operations.compare + shift + branches.taken + go_on,
          whole + 2 * std::uint64_t{branches.passed}};
}

/// What the instructions of a part take at a node's pixels, which are numbered row by row.
class AtPixels {
 public:
  /// `nodes`: of which each has every so-many-th pixel.
  AtPixels(const ListPart& part, const NodePixels& own, const Figures& figures, const isa::ArrayShape& nodes)
      : part_(part), own_(own), figures_(figures), nodes_(nodes) {
    if (part.met != nullptr && !part.instructions.empty()) row_ = row_mask(own.columns);
  }

  /// Of an instruction at those from `begin` to `end`.
  [[nodiscard]] std::uint64_t clocks(std::size_t index, std::uint64_t begin, std::uint64_t end) const {
    const Prices prices = prices_of(part_.instructions[index], figures_);
    if (part_.met == nullptr) return (end - begin) * prices.most();
    const Pixels pixels = pixels_of(index, begin, end);
    return (end - begin - pixels.enabled) * prices.disabled + at_enabled(pixels, prices);
  }

  /// Of an instruction at all of them.
  [[nodiscard]] machines::PixelClocks of_all(std::size_t index) const {
    const std::uint64_t all = clocks(index, 0, own_.count());
    if (part_.met == nullptr) return {all, all};
    return {all, at_enabled(pixels_of(index, 0, own_.count()), prices_of(part_.instructions[index], figures_))};
  }

 private:
  struct Pixels {
    std::uint64_t enabled = 0;
    std::uint64_t chosen = 0;
  };

  static std::uint64_t at_enabled(const Pixels& pixels, const Prices& prices) {
    return (pixels.enabled - pixels.chosen) * prices.unchosen + pixels.chosen * prices.whole;
  }

  [[nodiscard]] Pixels pixels_of(std::size_t index, std::uint64_t begin, std::uint64_t end) const {
    const machines::MetPixels::Planes planes = part_.met->instructions[part_.first + index];
    const auto in = [&](std::uint32_t plane) { return count(plane, end) - count(plane, begin); };
    const std::uint64_t enabled = in(planes.enabled);
    return {enabled, planes.chosen == planes.enabled ? enabled : in(planes.chosen)};
  }

  /// Of a row of the plane, the bits of the node's first so many pixels.
  [[nodiscard]] std::vector<std::uint64_t> row_mask(std::uint64_t columns) const {
    std::vector<std::uint64_t> mask(part_.met->row_words);
    for (std::uint64_t column = 0; column < columns; ++column) {
      const std::uint64_t x = own_.first_x + column * nodes_.width;
      mask[static_cast<std::size_t>(x / word_bits)] |= std::uint64_t{1} << x % word_bits;
    }
    return mask;
  }

  /// Of the pixels before that one, those in the plane.
  [[nodiscard]] std::uint64_t count(std::uint32_t plane, std::uint64_t end) const {
    const std::vector<std::uint64_t>& words = part_.met->planes[plane];
    if (words.empty() || end == 0) return 0;
    std::uint64_t sum = 0;
    const auto add_row = [&](std::uint64_t row, const std::vector<std::uint64_t>& mask) {
      const std::uint64_t* const bits =
          &words[static_cast<std::size_t>(own_.first_y + row * nodes_.height) * mask.size()];
      for (std::size_t i = 0; i < mask.size(); ++i) sum += static_cast<std::uint64_t>(std::popcount(bits[i] & mask[i]));
    };
    const std::uint64_t whole_rows = end / own_.columns;
    for (std::uint64_t row = 0; row < whole_rows; ++row) add_row(row, row_);
    if (end % own_.columns > 0) add_row(whole_rows, row_mask(end % own_.columns));
    return sum;
  }

  static constexpr std::uint64_t word_bits = 64;

  const ListPart& part_;
  const NodePixels& own_;
  const Figures& figures_;
  const isa::ArrayShape nodes_;
  std::vector<std::uint64_t> row_;  ///< bits of the node's pixels in a row of a plane
};

/// Of an instruction at so many rows of pixels and pixels, at which it takes `at_pixels` in all.
std::uint64_t instruction_clocks(const isa::Instruction& instruction, const ListForm& form, std::uint64_t rows,
                                 std::uint64_t pixels, std::uint64_t at_pixels, const Figures& figures) {
  const std::uint64_t reach = reach_clocks(instruction, form, figures);
  const std::uint64_t pixel_loop = pixels * figures.loop.pixel;
  switch (figures.order) {
    case RenderingOrder::segment:
      return reach + sum_clocks(instruction, 2, figures) +
             rows * (add_clocks(instruction, figures) + figures.loop.row) + at_pixels + pixel_loop;
    case RenderingOrder::scan_line:
      return rows * (reach + sum_clocks(instruction, 1, figures)) + at_pixels + pixel_loop;
    case RenderingOrder::pixel: return pixels * reach + at_pixels;
  }
  return 0;
}

}  // namespace

std::uint64_t written_bits(const isa::Command& command, const ListForm& form) {
  const auto* const instruction = std::get_if<isa::Instruction>(&command);
  const std::uint64_t bits = isa::wire_bits(command);
  if (instruction == nullptr || !form.has_numbers || instruction->linear.width == 0) return bits;
  if (!is_named(*instruction, form)) return bits + 1;
  const std::uint64_t expression =
      isa::wire_linear_width_bits + isa::wire_shift_bits + 3 * std::uint64_t{instruction->linear.width};
  return bits - expression + 1 + form.number_bits + number_width_bits;
}

std::uint64_t pixel_clocks(const isa::Instruction& instruction, const Machine& machine) {
  return prices_of(instruction, machines::own<Figures>(machine)).whole;
}

machines::PixelClocks all_pixel_clocks(const isa::Segment& segment, std::size_t index, const Machine& machine,
                                       const machines::MetPixels* met) {
  const Figures& figures = machines::own<Figures>(machine);
  const ListPart part{.instructions = std::span(segment.instructions).subspan(index, 1), .met = met, .first = index};
  const NodePixels all{0, 0, segment.region.width, segment.region.height};
  return AtPixels(part, all, figures, {1, 1, 0}).of_all(0);
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

std::uint64_t rendering_clocks(const ListPart& part, const NodePixels& own, isa::Field colour, const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  const bool has_instructions = !part.instructions.empty();
  if (own.count() == 0) return 0;
  std::uint64_t clocks = 0;
  if (has_instructions) {
    clocks += outer_clocks(own, figures);
    if (part.begins) clocks += clearing_clocks(own, machine);
    clocks += chain_clocks(part.instructions, part.form, figures);
  }
  const AtPixels at(part, own, figures, machine.array);
  for (std::size_t i = 0; i < part.instructions.size(); ++i)
    clocks += instruction_clocks(part.instructions[i], part.form, own.rows, own.count(), at.clocks(i, 0, own.count()),
                                 figures);
  if (!part.ends || colour.width == 0) return clocks;
  const bool is_background = part.begins && !has_instructions;
  const std::uint64_t words = words_of(colour.width, figures);
  const std::uint64_t reads = is_background ? 0 : words * figures.operations.read;
  return clocks + pass_clocks(own, reads + words * figures.operations.write, figures);
}

std::uint64_t clearing_clocks(const NodePixels& own, const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  const std::uint64_t memory_words = words_of(machine.array.memory_bits, figures) + 1;
  return pass_clocks(own, memory_words * figures.operations.write, figures);
}

/// The loops of an order, from the outermost in, begin a row and a pixel of it as many times as there are before this.
std::vector<machines::ClockSpan> spans_at_pixel(const ListPart& part, const NodePixels& own, std::uint32_t column,
                                                std::uint32_t row, const Machine& machine) {
  const std::span<const isa::Instruction> list = part.instructions;
  const Figures& figures = machines::own<Figures>(machine);
  const AtPixels at(part, own, figures, machine.array);
  const std::uint64_t row_begin = std::uint64_t{row} * own.columns;
  const std::uint64_t here = row_begin + column;
  const auto at_all = [&](std::uint64_t rows, std::uint64_t begin, std::uint64_t end) {
    std::uint64_t clocks = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
      clocks += instruction_clocks(list[i], part.form, rows, end - begin, at.clocks(i, begin, end), figures);
    return clocks;
  };
  std::uint64_t now = (part.begins ? clearing_clocks(own, machine) : 0) + chain_clocks(list, part.form, figures);
  if (figures.order != RenderingOrder::segment) {
    now += outer_clocks({.columns = own.columns, .rows = row}, figures) + at_all(row, 0, row_begin);
    if (figures.order == RenderingOrder::pixel)
      now += column * std::uint64_t{figures.loop.pixel} + at_all(0, row_begin, here);
  }
  std::vector<machines::ClockSpan> spans;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const isa::Instruction& instruction = list[i];
    std::uint64_t begin = now + reach_clocks(instruction, part.form, figures);
    const auto all = [&](std::uint64_t rows, std::uint64_t first, std::uint64_t end) {
      return instruction_clocks(instruction, part.form, rows, end - first, at.clocks(i, first, end), figures);
    };
    switch (figures.order) {
      case RenderingOrder::segment:
        begin = now + all(row, 0, here);
        now += all(own.rows, 0, own.count());
        break;
      case RenderingOrder::scan_line:
        begin = now + all(1, row_begin, here);
        now += all(1, row_begin, row_begin + own.columns);
        break;
      case RenderingOrder::pixel: now += all(0, here, here + 1); break;
    }
    spans.push_back({begin, begin + at.clocks(i, here, here + 1)});
  }
  return spans;
}

double most_rendering_clocks(std::span<const isa::Instruction> list, const isa::Region& region, const ListForm& form,
                             const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  double clocks = 0;
  for (const isa::Instruction& instruction : list) {
    clocks += static_cast<double>(prices_of(instruction, figures).most() + reach_clocks(instruction, form, figures) +
                                  sum_clocks(instruction, 2, figures) + figures.loop.pixel + figures.loop.row);
  }
  clocks += static_cast<double>(chain_clocks(list, form, figures));
  const std::uint64_t words = words_of(machine.array.memory_bits + 2ULL * isa::max_field_width, figures) + 4;
  clocks += static_cast<double>(words * (std::uint64_t{figures.operations.read} + figures.operations.write) +
                                3 * (std::uint64_t{figures.loop.pixel} + figures.loop.row));
  return 2 * clocks * region.width * region.height;
}

}  // namespace csgsim::multi_processor
