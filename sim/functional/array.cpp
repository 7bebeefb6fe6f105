#include "sim/functional/array.h"

#include <algorithm>
#include <vector>

#include "hw/isa/opcodes.h"
#include "sim/functional/edge.h"
#include "sim/functional/linear_kernels.h"
#include "sim/functional/word_kernels.h"

namespace csgsim::sim {

namespace {

using isa::Field;
using isa::Instruction;
using isa::Linear;
using isa::Opcode;

/// Fields no wider than this stay in bit planes as long as only bits of theirs are moved and compared.
constexpr unsigned max_width_as_bits = 8;

std::uint64_t modular(std::int64_t value) { return static_cast<std::uint64_t>(value); }

HalfPlane where_not_negative(const Linear& linear, std::uint32_t first_row) {
  return {linear.a, linear.b, linear.c + linear.b * first_row};
}

HalfPlane where_negative(const Linear& linear, std::uint32_t first_row) {
  const HalfPlane opposite = where_not_negative(linear, first_row);
  return {-opposite.a, -opposite.b, -opposite.c - 1};
}

/// What the kernel has to do for the opcode: see LinearTask.
struct Recipe {
  LinearKind kind = LinearKind::sign;
  bool negate = false;
  std::uint64_t bias = 0;
};

Recipe recipe_for(Opcode opcode, unsigned shift) {
  const std::uint64_t for_greater = 1 - (std::uint64_t{1} << shift);
  constexpr std::uint64_t for_not_less = 1;
  switch (opcode) {
    case Opcode::edge_not_negative: return {LinearKind::sign, false, for_not_less};
    case Opcode::edge_negative:
    case Opcode::stripe: return {LinearKind::sign, true, for_not_less};
    case Opcode::linear_ge: return {LinearKind::compare, false, for_not_less};
    case Opcode::linear_gt: return {LinearKind::compare, false, for_greater};
    case Opcode::linear_le: return {LinearKind::compare, true, for_greater};
    case Opcode::linear_lt: return {LinearKind::compare, true, for_not_less};
    case Opcode::linear_eq: return {LinearKind::equal};
    case Opcode::load_linear: return {LinearKind::load};
    case Opcode::keep_max: return {LinearKind::keep_max, false, for_greater};
    case Opcode::keep_min: return {LinearKind::keep_min};
    case Opcode::enable_all:
    case Opcode::enable_invert:
    case Opcode::enable_load:
    case Opcode::enable_and:
    case Opcode::enable_and_not:
    case Opcode::enable_or:
    case Opcode::enable_xor:
    case Opcode::enable_store:
    case Opcode::set_constant:
    case Opcode::copy:
    case Opcode::field_lt:
    case Opcode::field_le:
    case Opcode::field_eq:
    case Opcode::bit_and:
    case Opcode::bit_or:
    case Opcode::bit_xor:
    case Opcode::bit_and_not:
    case Opcode::bit_not:
    case Opcode::global_or:
    case Opcode::xor_constant:
    case Opcode::skip_if_none:
    case Opcode::add: break;
  }
  return {};
}

}  // namespace

Array::Array(std::uint32_t width, std::uint32_t first_row, std::uint32_t rows, std::uint32_t memory_bits)
    : width_(width),
      first_row_(first_row),
      rows_(rows),
      memory_(width, rows, memory_bits),
      enable_(width, rows),
      first_copy_(width, rows),
      second_copy_(width, rows) {}

void Array::clear() {
  memory_.clear();
  enable_.clear();
  enabled_ = 0;
}

WordBlock Array::enable_block() {
  enable_.materialise();
  return enable_.block();
}

void Array::read_enable(std::span<std::uint64_t> words) const {
  const std::uint32_t words_per_row = enable_.words_per_row();
  for (std::uint32_t row = 0; row < rows_; ++row)
    for (std::uint32_t column = 0; column < words_per_row; ++column)
      words[enable_.offset(row, column)] = enable_.word(row, column);
}

std::uint64_t Array::execute(const Instruction& instruction) {
  const auto& fields = instruction.fields;
  switch (instruction.opcode) {
    case Opcode::enable_all:
      enable_.fill(whole());
      enabled_ = whole().area();
      return 0;
    case Opcode::enable_invert: invert_enable(); return 0;
    case Opcode::enable_load:
    case Opcode::enable_and:
    case Opcode::enable_and_not:
    case Opcode::enable_or:
    case Opcode::enable_xor: combine_enable(instruction.opcode, fields[0].base); return 0;
    case Opcode::enable_store: memory_.plane(fields[0].base).assign(enable_); return 0;
    case Opcode::edge_not_negative:
    case Opcode::edge_negative:
    case Opcode::stripe:
    case Opcode::linear_ge:
    case Opcode::linear_gt:
    case Opcode::linear_le:
    case Opcode::linear_lt:
    case Opcode::linear_eq:
    case Opcode::load_linear:
    case Opcode::keep_max:
    case Opcode::keep_min: return enabled_ == 0 ? 0 : execute_linear(instruction);
    case Opcode::set_constant: set_constant(fields[0], instruction.constant); return 0;
    case Opcode::copy: copy(fields[0], fields[1]); return 0;
    case Opcode::field_lt:
    case Opcode::field_le:
    case Opcode::field_eq: compare(instruction.opcode, fields[0], fields[1]); return 0;
    case Opcode::bit_and:
    case Opcode::bit_or:
    case Opcode::bit_xor:
    case Opcode::bit_and_not:
    case Opcode::bit_not: combine_bits(instruction); return 0;
    case Opcode::global_or:
    case Opcode::skip_if_none: return 0;
    case Opcode::xor_constant: xor_constant(fields[0], instruction.constant); return 0;
    case Opcode::add: add(fields[0], fields[1]); return 0;
  }
  return 0;
}

void Array::invert_enable() {
  if (enable_.bounds().empty()) {
    enable_.fill(whole());
  } else if (enable_.solid() && enable_.bounds() == whole()) {
    enable_.clear();
  } else {
    enable_.cover(whole());
    const Cells cells(whole());
    for (std::uint32_t row = 0; row < cells.rows; ++row)
      for (std::uint32_t column = 0; column < cells.columns; ++column)
        enable_.set_word(row, column, enable_.word(row, column) ^ BitPlane::columns_mask(whole(), column));
  }
  recount();
}

void Array::combine_enable(Opcode opcode, unsigned bit) {
  const bool within_enable = opcode == Opcode::enable_and || opcode == Opcode::enable_and_not;
  const BitPlane& source = memory_.read(bit, within_enable ? enable_.bounds() : whole(), first_copy_);

  if (opcode == Opcode::enable_load) {
    enable_.assign(source);
    recount();
    return;
  }
  if (opcode == Opcode::enable_and && enable_.solid() && contains(enable_.bounds(), source.bounds())) {
    enable_.assign(source);
    recount();
    return;
  }
  enable_.materialise();
  Rect changed = intersection(enable_.bounds(), source.bounds());
  if (opcode == Opcode::enable_and) {
    // A word may hold pixels of E outside the source's bounds: the loop below clears them.
    const Cells cells(changed);
    for (std::uint32_t row = cells.row; row < cells.row + cells.rows; ++row)
      for (std::uint32_t column = cells.column; column < cells.column + cells.columns; ++column)
        enable_.set_word(row, column, enable_.word(row, column) & source.word(row, column));
    enable_.narrow(changed);
    recount();
    return;
  }
  if (!within_enable) {
    enable_.cover(source.bounds());
    changed = source.bounds();
  }
  const Cells cells(changed);
  for (std::uint32_t row = cells.row; row < cells.row + cells.rows; ++row)
    for (std::uint32_t column = cells.column; column < cells.column + cells.columns; ++column) {
      const std::uint64_t e = enable_.word(row, column);
      const std::uint64_t s = source.word(row, column);
      const std::uint64_t combined = opcode == Opcode::enable_or    ? e | s
                                     : opcode == Opcode::enable_xor ? e ^ s
                                                                    : e & ~s;
      enable_.set_word(row, column, combined);
    }
  recount();
}

bool Array::can_wrap(const Linear& linear) const {
  const Rect& rect = enable_.bounds();
  const std::int64_t left = linear.a * rect.x0;
  const std::int64_t right = linear.a * (static_cast<std::int64_t>(rect.x1) - 1);
  const std::int64_t top = linear.b * (static_cast<std::int64_t>(first_row_) + rect.y0);
  const std::int64_t bottom = linear.b * (static_cast<std::int64_t>(first_row_) + rect.y1 - 1);
  const std::int64_t lowest = std::min(left, right) + std::min(top, bottom) + linear.c;
  const std::int64_t highest = std::max(left, right) + std::max(top, bottom) + linear.c;
  const std::int64_t limit = std::int64_t{1} << (linear.width - 1);
  return lowest < -limit || highest >= limit;
}

std::uint64_t Array::execute_linear(const Instruction& instruction) {
  const Linear& linear = instruction.linear;
  const bool wraps = can_wrap(linear);
  const bool is_edge = !instruction.fields[0].width;
  if (is_edge && !wraps) {
    const bool positive = instruction.opcode == Opcode::edge_not_negative;
    clip(enable_, positive ? where_not_negative(linear, first_row_) : where_negative(linear, first_row_));
    recount();
    return 0;
  }
  return execute_on_linear_kernel(instruction, wraps);
}

std::uint64_t Array::execute_on_linear_kernel(const Instruction& instruction, bool wraps) {
  const Linear& linear = instruction.linear;
  const Recipe recipe = recipe_for(instruction.opcode, linear.shift);
  const Rect bounds = enable_.bounds();
  const Cells cells(bounds);
  LinearTask task;
  task.kind = recipe.kind;
  task.wraps = wraps;
  task.negate = recipe.negate;
  task.bias = recipe.bias;
  task.a = modular(linear.a);
  task.b = modular(linear.b);
  task.start = modular(linear.c) + task.a * cells.column * word_bits + task.b * (first_row_ + cells.row);
  task.width = linear.width;
  task.shift = linear.shift;
  if (const Field field = instruction.fields[0]; field.width > 0) {
    Lanes& lanes = memory_.lanes(field);
    task.field_width = field.width;
    task.lanes = memory_.at(lanes, bounds);
    const bool writes = isa::info(instruction.opcode).operands[0] == isa::OperandKind::target;
    if (writes) lanes.bounds = hull(lanes.bounds, bounds);
  }
  const std::uint64_t overflows = run_linear(enable_block(), task);
  recount();
  return isa::cuts_sum(instruction.opcode) ? 0 : overflows;
}

bool Array::as_bits(Field first, Field second) const {
  if (first.width == 1) return true;
  return first.width <= max_width_as_bits && memory_.in_planes(first) &&
         (second.width == 0 || memory_.in_planes(second));
}

void Array::set_constant(Field target, std::uint64_t constant) {
  const Rect bounds = enable_.bounds();
  if (as_bits(target, {})) {
    for (unsigned bit = 0; bit < target.width; ++bit) {
      const bool one = (constant >> bit & 1U) != 0;
      write_where(enable_, memory_.plane(target.base + bit), one ? bounds : Rect{},
                  [one](std::uint32_t, std::uint32_t) { return one ? ~std::uint64_t{0} : 0; });
    }
    return;
  }
  if (const std::vector<Field> parts = memory_.parts(target); !parts.empty()) {
    for (const Field& part : parts) {
      const std::uint64_t ones = (std::uint64_t{1} << part.width) - 1;
      set_constant(part, constant >> static_cast<unsigned>(part.base - target.base) & ones);
    }
    return;
  }
  Lanes& lanes = memory_.lanes(target);
  if (bounds.empty()) return;
  set_lanes(enable_block(), memory_.at(lanes, bounds), static_cast<std::uint32_t>(constant));
  lanes.bounds = hull(lanes.bounds, bounds);
}

/// Whether the source is held in parts as those of the target.
bool Array::has_parts_of(Field source, Field target, const std::vector<Field>& parts) const {
  const std::vector<Field> others = memory_.parts(source);
  return std::equal(parts.begin(), parts.end(), others.begin(), others.end(),
                    [&](const Field& one, const Field& other) {
                      return one.width == other.width && one.base - target.base == other.base - source.base;
                    });
}

void Array::copy(Field target, Field source) {
  const Rect bounds = enable_.bounds();
  if (as_bits(target, source)) {
    for (unsigned bit = 0; bit < target.width; ++bit) {
      BitPlane& to = memory_.plane(target.base + bit);
      const BitPlane& from = memory_.read(source.base + bit, bounds, first_copy_);
      write_where(enable_, to, from.bounds(),
                  [&from](std::uint32_t row, std::uint32_t column) { return from.word(row, column); });
    }
    return;
  }
  if (const std::vector<Field> parts = memory_.parts(target); !parts.empty() && has_parts_of(source, target, parts)) {
    for (const Field& part : parts)
      copy(part, {static_cast<std::uint16_t>(source.base + part.base - target.base), part.width});
    return;
  }
  Lanes& to = memory_.lanes(target);
  Lanes& from = memory_.lanes(source);
  if (bounds.empty()) return;
  copy_lanes(enable_block(), memory_.at(to, bounds), memory_.at(from, bounds));
  to.bounds = hull(to.bounds, intersection(bounds, from.bounds));
}

void Array::compare(Opcode opcode, Field left, Field right) {
  const Rect bounds = enable_.bounds();
  if (bounds.empty()) return;
  const Comparison comparison = opcode == Opcode::field_lt   ? Comparison::less
                                : opcode == Opcode::field_le ? Comparison::less_or_equal
                                                             : Comparison::equal;
  if (!as_bits(left, right)) {
    Lanes& s = memory_.lanes(left);
    Lanes& r = memory_.lanes(right);
    compare_lanes(enable_block(), comparison, memory_.at(s, bounds), memory_.at(r, bounds));
    recount();
    return;
  }
  const WordBlock enable = enable_block();
  const Cells cells(bounds);
  const std::size_t words = std::size_t{cells.rows} * cells.columns;
  std::vector<std::uint64_t> less(words, 0);
  std::vector<std::uint64_t> differ(words, 0);
  for (unsigned bit = 0; bit < left.width; ++bit) {
    const BitPlane& s = memory_.read(left.base + bit, bounds, first_copy_);
    const BitPlane& r = memory_.read(right.base + bit, bounds, second_copy_);
    for (std::size_t i = 0; i < words; ++i) {
      const auto row = cells.row + static_cast<std::uint32_t>(i / cells.columns);
      const auto column = cells.column + static_cast<std::uint32_t>(i % cells.columns);
      const std::uint64_t s_word = s.word(row, column);
      const std::uint64_t r_word = r.word(row, column);
      less[i] = (~s_word & r_word) | (~(s_word ^ r_word) & less[i]);
      differ[i] |= s_word ^ r_word;
    }
  }
  for (std::size_t i = 0; i < words; ++i) {
    std::uint64_t& word = enable.words[i / cells.columns * enable.stride + i % cells.columns];
    switch (comparison) {
      case Comparison::less: word &= less[i]; break;
      case Comparison::less_or_equal: word &= less[i] | ~differ[i]; break;
      case Comparison::equal: word &= ~differ[i]; break;
    }
  }
  recount();
}

void Array::combine_bits(const Instruction& instruction) {
  const auto [target, left, right] = instruction.fields;
  for (unsigned bit = 0; bit < target.width; ++bit) {
    combine_bit(instruction.opcode, target.base + bit, left.base + bit, right.base + bit);
  }
}

void Array::combine_bit(Opcode opcode, unsigned target, unsigned left, unsigned right) {
  const Rect bounds = enable_.bounds();
  BitPlane& t = memory_.plane(target);
  const BitPlane& s = memory_.read(left, bounds, first_copy_);
  const bool is_not = opcode == Opcode::bit_not;
  const BitPlane& r = is_not ? s : memory_.read(right, bounds, second_copy_);
  const auto write = [&](const Rect& ones, auto combine) {
    write_where(enable_, t, ones, [&s, &r, combine](std::uint32_t row, std::uint32_t column) {
      return combine(s.word(row, column), r.word(row, column));
    });
  };
  using Word = std::uint64_t;
  if (is_not)
    write(bounds, [](Word a, Word) { return ~a; });
  else if (opcode == Opcode::bit_and)
    write(intersection(s.bounds(), r.bounds()), [](Word a, Word b) { return a & b; });
  else if (opcode == Opcode::bit_or)
    write(hull(s.bounds(), r.bounds()), [](Word a, Word b) { return a | b; });
  else if (opcode == Opcode::bit_xor)
    write(hull(s.bounds(), r.bounds()), [](Word a, Word b) { return a ^ b; });
  else
    write(s.bounds(), [](Word a, Word b) { return a & ~b; });
}

void Array::add(Field target, Field source) {
  const Rect bounds = enable_.bounds();
  if (bounds.empty()) return;
  if (as_bits(target, source)) return add_bits(target, source);
  Lanes& to = memory_.lanes(target);
  Lanes& from = memory_.lanes(source);
  const std::uint32_t low_bits = ~std::uint32_t{0} >> (isa::max_field_width - target.width);
  add_lanes(enable_block(), memory_.at(to, bounds), memory_.at(from, bounds), low_bits);
  to.bounds = hull(to.bounds, intersection(bounds, from.bounds));
}

/// A full adder a word of pixels at a time, its carry rippling from bit to bit.
void Array::add_bits(Field target, Field source) {
  const Rect bounds = enable_.bounds();
  const Cells cells(bounds);
  std::vector<std::uint64_t> carries(std::size_t{cells.rows} * cells.columns, 0);
  for (unsigned bit = 0; bit < target.width; ++bit) {
    BitPlane& t = memory_.plane(target.base + bit);
    const bool in_source = bit < source.width;
    const BitPlane* const s = in_source ? &memory_.read(source.base + bit, bounds, first_copy_) : nullptr;
    write_where(enable_, t, bounds, [&](std::uint32_t row, std::uint32_t column) {
      std::uint64_t& carry = carries[std::size_t{row - cells.row} * cells.columns + column - cells.column];
      const std::uint64_t t_word = t.word(row, column);
      const std::uint64_t s_word = s == nullptr ? 0 : s->word(row, column);
      const std::uint64_t half = t_word ^ s_word;
      const std::uint64_t sum = half ^ carry;
      carry = (t_word & s_word) | (half & carry);
      return sum;
    });
  }
}

void Array::xor_constant(Field target, std::uint64_t constant) {
  for (unsigned bit = 0; bit < target.width; ++bit) {
    if ((constant >> bit & 1U) != 0) combine_bit(Opcode::bit_not, target.base + bit, target.base + bit, 0);
  }
}

}  // namespace csgsim::sim
