#include "hw/multi_processor/clocks.h"

#include <algorithm>

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

std::uint64_t fetch_clocks(const isa::Instruction& instruction, const Figures& figures) {
  return figures.loop.instruction + words_of(isa::wire_bits(instruction), figures) * figures.operations.read +
         unpacking_clocks(isa::WireFields(instruction).widths(), figures);
}

/// Loops over the pixels around something that is done at each.
std::uint64_t pass_clocks(const NodePixels& own, std::uint64_t at_each, const Figures& figures) {
  return own.count() * (at_each + figures.loop.pixel) + own.rows * std::uint64_t{figures.loop.row};
}

std::uint64_t instruction_clocks(const isa::Instruction& instruction, const NodePixels& own, const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  const std::uint64_t fetch = fetch_clocks(instruction, figures);
  const std::uint64_t at_each = own.count() * pixel_clocks(instruction, machine);
  const std::uint64_t pixel_loop = own.count() * figures.loop.pixel;
  const std::uint64_t row_loop = own.rows * std::uint64_t{figures.loop.row};
  switch (figures.order) {
    case RenderingOrder::segment:
      return fetch + sum_clocks(instruction, 2, figures) + own.rows * add_clocks(instruction, figures) + at_each +
             pixel_loop + row_loop;
    case RenderingOrder::scan_line:
      return own.rows * (fetch + sum_clocks(instruction, 1, figures)) + at_each + pixel_loop;
    case RenderingOrder::pixel: return own.count() * fetch + at_each;
  }
  return 0;
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

}  // namespace

std::uint64_t pixel_clocks(const isa::Instruction& instruction, const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  const OperationClocks& operations = figures.operations;
  const Work work = work_of(instruction, figures);
  const isa::Linear& linear = instruction.linear;
  const std::uint64_t shifts = work.shifts + (linear.width > 0 ? shift_clocks(linear.width, linear.shift, figures) : 0);
  const std::uint64_t sum =
      figures.order == RenderingOrder::pixel ? sum_clocks(instruction, 0, figures) : add_clocks(instruction, figures);
  return (1 + work.reads) * operations.read + work.writes * operations.write + work.compares * operations.compare +
         (1 + work.combines) * operations.logic + work.adds * operations.add + shifts + sum;
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
  }
  for (const isa::Instruction& instruction : part.instructions) clocks += instruction_clocks(instruction, own, machine);
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
  const NodePixels rows_above{.columns = own.columns, .rows = row};
  const NodePixels one_row{.columns = own.columns, .rows = 1};
  const NodePixels one_pixel{.columns = 1, .rows = 1};
  const auto all = [&](const NodePixels& pixels) {
    std::uint64_t clocks = outer_clocks(pixels, figures);
    for (const isa::Instruction& instruction : list) clocks += instruction_clocks(instruction, pixels, machine);
    return clocks;
  };
  std::uint64_t now = part.begins ? clearing_clocks(own, machine) : 0;
  switch (figures.order) {
    case RenderingOrder::segment: break;
    case RenderingOrder::scan_line: now += all(rows_above); break;
    case RenderingOrder::pixel: now += all(rows_above) + column * (all(one_pixel) - figures.loop.row); break;
  }
  std::vector<machines::ClockSpan> spans;
  for (const isa::Instruction& instruction : list) {
    const std::uint64_t at_each = pixel_clocks(instruction, machine);
    std::uint64_t begin = now + fetch_clocks(instruction, figures);
    switch (figures.order) {
      case RenderingOrder::segment:
        begin += sum_clocks(instruction, 2, figures) + row * (add_clocks(instruction, figures) + figures.loop.row) +
                 (std::uint64_t{row} * own.columns + column) * (at_each + figures.loop.pixel);
        now += instruction_clocks(instruction, own, machine);
        break;
      case RenderingOrder::scan_line:
        begin += sum_clocks(instruction, 1, figures) + column * (at_each + figures.loop.pixel);
        now += instruction_clocks(instruction, one_row, machine);
        break;
      case RenderingOrder::pixel: now += instruction_clocks(instruction, one_pixel, machine); break;
    }
    spans.push_back({begin, begin + at_each});
  }
  return spans;
}

double most_rendering_clocks(std::span<const isa::Instruction> list, const isa::Region& region,
                             const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  double clocks = 0;
  for (const isa::Instruction& instruction : list) {
    clocks += static_cast<double>(pixel_clocks(instruction, machine) + fetch_clocks(instruction, figures) +
                                  sum_clocks(instruction, 2, figures) + figures.loop.pixel + figures.loop.row);
  }
  const std::uint64_t words = words_of(machine.array.memory_bits + 2ULL * isa::max_field_width, figures) + 4;
  clocks += static_cast<double>(words * (std::uint64_t{figures.operations.read} + figures.operations.write) +
                                3 * (std::uint64_t{figures.loop.pixel} + figures.loop.row));
  return 2 * clocks * region.width * region.height;
}

}  // namespace csgsim::multi_processor
