#include "sim/functional/tile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include "hw/isa/opcodes.h"
#include "sim/functional/linear_kernels.h"
#include "sim/functional/quadratic_kernels.h"
#include "sim/functional/root_kernels.h"

namespace csgsim::functional {

namespace {

using isa::Field;
using isa::Instruction;
using isa::Opcode;

/// Fields up to this width stay in bit planes as long as only their bits are moved and compared.
constexpr unsigned max_width_as_bits = 8;

using WidePlanes = std::array<TileBits*, isa::max_wide_field_width>;

}  // namespace

Tile::Tile(std::uint32_t x, std::uint32_t y, TileShape shape, std::uint32_t memory_bits, Decide decide)
    : x_(x), y_(y), shape_(shape), decide_(decide), memory_(shape, memory_bits) {}

void Tile::clear() {
  memory_.clear();
  enable_.clear();
  squares_ = {};
  enabled_ = 0;
}

void Tile::write_enable(const std::uint64_t* rows, std::size_t stride) {
  read_rows(rows, stride, shape_, enable_);
  enabled_ = count_ones(enable_, shape_);
}

void Tile::write_bit(unsigned bit, const std::uint64_t* rows, std::size_t stride) {
  read_rows(rows, stride, shape_, memory_.plane(bit));
}

std::uint64_t Tile::execute(const Instruction& instruction) {
  const auto& fields = instruction.fields;
  ++work_.instructions;
  switch (instruction.opcode) {
    case Opcode::enable_all:
      enable_.fill(shape_);
      enabled_ = shape_.area();
      return 0;
    case Opcode::enable_invert: invert_enable(); break;
    case Opcode::enable_load:
      if (enabled_ == 0 && memory_.is_zero(fields[0].base)) return 0;
      [[fallthrough]];
    case Opcode::enable_and:
    case Opcode::enable_and_not:
    case Opcode::enable_or:
    case Opcode::enable_xor: combine_enable(instruction.opcode, fields[0].base); break;
    case Opcode::enable_store: memory_.plane(fields[0].base).assign(enable_); return 0;
    case Opcode::edge_not_negative: return execute_linear(instruction, LinearKind::not_negative);
    case Opcode::edge_negative:
    case Opcode::stripe: return execute_linear(instruction, LinearKind::negative);
    case Opcode::linear_ge: return execute_linear(instruction, LinearKind::greater_or_equal);
    case Opcode::linear_gt: return execute_linear(instruction, LinearKind::greater);
    case Opcode::linear_le: return execute_linear(instruction, LinearKind::less_or_equal);
    case Opcode::linear_lt: return execute_linear(instruction, LinearKind::less);
    case Opcode::linear_eq: return execute_linear(instruction, LinearKind::equal);
    case Opcode::load_linear: return execute_linear(instruction, LinearKind::load);
    case Opcode::keep_max: return execute_linear(instruction, LinearKind::keep_max);
    case Opcode::keep_min: return execute_linear(instruction, LinearKind::keep_min);
    case Opcode::linear_plus: return execute_linear(instruction, LinearKind::plus);
    case Opcode::linear_minus: return execute_linear(instruction, LinearKind::minus);
    case Opcode::set_constant: set_constant(fields[0], instruction.constant); return 0;
    case Opcode::copy: copy(fields[0], fields[1]); return 0;
    case Opcode::field_lt: compare(Comparison::less, fields[0], fields[1]); return 0;
    case Opcode::field_le: compare(Comparison::less_or_equal, fields[0], fields[1]); return 0;
    case Opcode::field_eq: compare(Comparison::equal, fields[0], fields[1]); return 0;
    case Opcode::bit_and: combine_bits(std::bit_and(), fields[0], fields[1], fields[2]); return 0;
    case Opcode::bit_or: combine_bits(std::bit_or(), fields[0], fields[1], fields[2]); return 0;
    case Opcode::bit_xor: combine_bits(std::bit_xor(), fields[0], fields[1], fields[2]); return 0;
    case Opcode::bit_and_not:
      combine_bits([](std::uint64_t left, std::uint64_t right) { return left & ~right; }, fields[0], fields[1],
                   fields[2]);
      return 0;
    case Opcode::bit_not: combine_bits(std::bit_not(), fields[0], fields[1], fields[2]); return 0;
    case Opcode::global_or:
    case Opcode::skip_if_none: return 0;
    case Opcode::xor_constant: xor_constant(fields[0], instruction.constant); return 0;
    case Opcode::add: add(fields[0], fields[1]); return 0;
    case Opcode::squares: squares_ = instruction.linear; return 0;
    case Opcode::root: root(fields[0]); return 0;
  }
  enabled_ = count_ones(enable_, shape_);
  return 0;
}

void Tile::invert_enable() {
  const std::uint64_t full = enable_.full();
  const std::uint64_t none = shape_.blocks() & ~enable_.any();
  each_bit(enable_.mixed(), [&](unsigned block) {
    enable_.set_word(block, enable_.word(block, shape_) ^ shape_.pixels(block), shape_);
  });
  enable_.clear_blocks(full);
  enable_.fill_blocks(none);
}

void Tile::combine_enable(Opcode opcode, unsigned bit) {
  const bool within_enable = opcode == Opcode::enable_and || opcode == Opcode::enable_and_not;
  const TileBits& source = memory_.read(bit, within_enable ? enable_.any() : shape_.blocks(), first_copy_);
  const auto combine = [&](std::uint64_t blocks, const auto& combined) {
    each_bit(blocks, [&](unsigned block) {
      enable_.set_word(block, combined(enable_.word(block, shape_), source.word(block, shape_)), shape_);
    });
  };
  using Word = std::uint64_t;
  if (opcode == Opcode::enable_load) {
    enable_.assign(source);
  } else if (opcode == Opcode::enable_and) {
    enable_.clear_blocks(~source.any());
    combine(enable_.any() & ~source.full(), [](Word e, Word s) { return e & s; });
  } else if (opcode == Opcode::enable_and_not) {
    enable_.clear_blocks(source.full());
    combine(enable_.any() & source.any(), [](Word e, Word s) { return e & ~s; });
  } else if (opcode == Opcode::enable_or) {
    enable_.fill_blocks(source.full());
    combine(source.mixed() & ~enable_.full(), [](Word e, Word s) { return e | s; });
  } else {
    combine(source.any(), [](Word e, Word s) { return e ^ s; });
  }
}

std::uint64_t Tile::execute_linear(const Instruction& instruction, LinearKind kind) {
  const isa::Linear squares = std::exchange(squares_, {});
  if (enabled_ == 0) return 0;
  LinearTask task;
  task.kind = kind;
  const Field field = instruction.fields[0];
  const bool is_linear = squares.width == 0 && field.width <= isa::max_field_width && kind != LinearKind::plus &&
                         kind != LinearKind::minus;
  LinearResult result;
  if (is_linear) {
    const auto& [a, b, c, width, shift] = instruction.linear;
    task.linear = {a, b, c + a * x_ + b * y_, width, shift};
    if (field.width > 0)
      task.lanes = &memory_.lanes(field, kind == LinearKind::load ? blocks_to_overwrite() : blocks_to_update());
    result = run_linear(pixels(), task, enabled_);
  } else {
    result = execute_quadratic(instruction, squares, kind);
  }
  enabled_ = result.enabled;
  return isa::may_exceed_width(instruction.opcode) ? 0 : result.overflows;
}

LinearResult Tile::execute_quadratic(const Instruction& instruction, const isa::Linear& squares, LinearKind kind) {
  const isa::Linear& linear = instruction.linear;
  QuadraticTask task{kind, QuadraticSum(squares, linear).from(x_, y_), linear.width, linear.shift, nullptr, {}};
  const Field field = instruction.fields[0];
  const TargetBlocks worked = kind == LinearKind::load ? blocks_to_overwrite() : blocks_to_update();
  WidePlanes planes{};
  if (field.width > isa::max_field_width) {
    memory_.planes(field, worked, planes);
    task.planes = std::span(planes).first(field.width);
  } else if (field.width > 0) {
    task.lanes = &memory_.lanes(field, worked);
  }
  return run_quadratic(pixels(), task);
}

void Tile::root(Field target) {
  if (enabled_ == 0) return;
  WidePlanes planes{};
  memory_.planes(target, blocks_to_update(), planes);
  execute_root(pixels(), std::span(planes).first(target.width));
}

bool Tile::is_faster_by_bits(Field target, Field source) const {
  if (target.width == 1) return true;
  return target.width <= max_width_as_bits && memory_.is_in_planes(target, enable_.any()) &&
         (source.width == 0 || memory_.is_in_planes(source, enable_.any()));
}

void Tile::set_constant(Field target, std::uint64_t constant) {
  if (enabled_ == 0) return;
  if (is_faster_by_bits(target, {})) {
    for (unsigned bit = 0; bit < target.width; ++bit) {
      TileBits& plane = memory_.plane(target.base + bit, enable_.any());
      const std::uint64_t value = (constant >> bit & 1U) != 0 ? ~std::uint64_t{0} : 0;
      work_.words += static_cast<std::uint64_t>(std::popcount(enable_.mixed()));
      if (value == 0) {
        plane.clear_blocks(enable_.full());
      } else {
        plane.fill_blocks(enable_.full());
      }
      each_bit(enable_.mixed(), [&](unsigned block) {
        const std::uint64_t mask = enable_.word(block, shape_);
        plane.set_word(block, (plane.word(block, shape_) & ~mask) | (value & mask), shape_);
      });
    }
    return;
  }
  if (!memory_.is_in_lanes(target, enable_.any())) {
    if (const std::vector<Field> parts = memory_.parts(target, enable_.any()); !parts.empty()) {
      for (const Field& part : parts) {
        const std::uint64_t ones = (std::uint64_t{1} << part.width) - 1;
        set_constant(part, constant >> static_cast<unsigned>(part.base - target.base) & ones);
      }
      return;
    }
  }
  set_lanes(pixels(), memory_.lanes(target, blocks_to_overwrite()), static_cast<std::uint32_t>(constant));
}

/// Whether the source is stored in the same parts as the target.
bool Tile::has_same_parts(Field source, Field target, const std::vector<Field>& parts) const {
  const std::vector<Field> others = memory_.parts(source, enable_.any());
  return std::equal(parts.begin(), parts.end(), others.begin(), others.end(),
                    [&](const Field& one, const Field& other) {
                      return one.width == other.width && one.base - target.base == other.base - source.base;
                    });
}

void Tile::copy(Field target, Field source) {
  if (enabled_ == 0) return;
  if (is_faster_by_bits(target, source)) {
    for (unsigned bit = 0; bit < target.width; ++bit) {
      TileBits& to = memory_.plane(target.base + bit, enable_.any());
      const TileBits& from = memory_.read(source.base + bit, enable_.any(), first_copy_);
      work_.words += static_cast<std::uint64_t>(std::popcount(enable_.any()));
      write_where(enable_, to, shape_, [&](unsigned block) { return from.word(block, shape_); });
    }
    return;
  }
  if (!memory_.is_in_lanes(target, enable_.any())) {
    if (const std::vector<Field> parts = memory_.parts(target, enable_.any());
        !parts.empty() && has_same_parts(source, target, parts)) {
      for (const Field& part : parts)
        copy(part, {static_cast<std::uint16_t>(source.base + part.base - target.base), part.width});
      return;
    }
  }
  Lanes& to = memory_.lanes(target, blocks_to_overwrite());
  copy_lanes(pixels(), to, memory_.lanes(source, blocks_to_update()));
}

void Tile::compare(Comparison comparison, Field left, Field right) {
  if (enabled_ == 0) return;
  if (is_faster_by_bits(left, right)) return compare_bits(comparison, left, right);
  Lanes& s = memory_.lanes(left, blocks_to_update());
  enabled_ = compare_lanes(pixels(), comparison, s, memory_.lanes(right, blocks_to_update()));
}

void Tile::compare_bits(Comparison comparison, Field left, Field right) {
  std::array<std::uint64_t, blocks_per_tile> less{};
  std::array<std::uint64_t, blocks_per_tile> differ{};
  const std::uint64_t blocks = enable_.any();
  work_.words += static_cast<std::uint64_t>(std::popcount(blocks)) * left.width;
  for (unsigned bit = 0; bit < left.width; ++bit) {
    const TileBits& s = memory_.read(left.base + bit, blocks, first_copy_);
    const TileBits& r = memory_.read(right.base + bit, blocks, second_copy_);
    each_bit(blocks, [&](unsigned block) {
      const std::uint64_t s_word = s.word(block, shape_);
      const std::uint64_t r_word = r.word(block, shape_);
      less[block] = (~s_word & r_word) | (~(s_word ^ r_word) & less[block]);
      differ[block] |= s_word ^ r_word;
    });
  }
  each_bit(blocks, [&](unsigned block) {
    const std::uint64_t holds = comparison == Comparison::less            ? less[block]
                                : comparison == Comparison::less_or_equal ? less[block] | ~differ[block]
                                                                          : ~differ[block];
    enable_.set_word(block, enable_.word(block, shape_) & holds, shape_);
  });
  enabled_ = count_ones(enable_, shape_);
}

template <class Combine>
void Tile::combine_bits(Combine combine, Field target, Field left, Field right) {
  if (enabled_ == 0) return;
  const std::uint64_t blocks = enable_.any();
  work_.words += static_cast<std::uint64_t>(std::popcount(blocks)) * target.width;
  for (unsigned bit = 0; bit < target.width; ++bit) {
    TileBits& t = memory_.plane(target.base + bit, enable_.any());
    const TileBits& s = memory_.read(left.base + bit, blocks, first_copy_);
    if constexpr (std::is_invocable_v<Combine, std::uint64_t>) {
      write_where(enable_, t, shape_, [&](unsigned block) { return combine(s.word(block, shape_)); });
    } else {
      const TileBits& r = memory_.read(right.base + bit, blocks, second_copy_);
      write_where(enable_, t, shape_,
                  [&](unsigned block) { return combine(s.word(block, shape_), r.word(block, shape_)); });
    }
  }
}

void Tile::add(Field target, Field source) {
  if (enabled_ == 0) return;
  if (is_faster_by_bits(target, source)) return add_bits(target, source);
  Lanes& to = memory_.lanes(target, blocks_to_update());
  const std::uint32_t low_bits = ~std::uint32_t{0} >> (isa::max_field_width - target.width);
  add_lanes(pixels(), to, memory_.lanes(source, blocks_to_update()), low_bits);
}

/// A full adder on words of pixels, with the carry rippling from bit to bit.
void Tile::add_bits(Field target, Field source) {
  std::array<std::uint64_t, blocks_per_tile> carries{};
  work_.words += static_cast<std::uint64_t>(std::popcount(enable_.any())) * target.width;
  for (unsigned bit = 0; bit < target.width; ++bit) {
    TileBits& t = memory_.plane(target.base + bit, enable_.any());
    const bool in_source = bit < source.width;
    const TileBits* const s = in_source ? &memory_.read(source.base + bit, enable_.any(), first_copy_) : nullptr;
    write_where(enable_, t, shape_, [&](unsigned block) {
      std::uint64_t& carry = carries[block];
      const std::uint64_t t_word = t.word(block, shape_);
      const std::uint64_t s_word = s == nullptr ? 0 : s->word(block, shape_);
      const std::uint64_t half = t_word ^ s_word;
      const std::uint64_t sum = half ^ carry;
      carry = (t_word & s_word) | (half & carry);
      return sum;
    });
  }
}

void Tile::xor_constant(Field target, std::uint64_t constant) {
  if (enabled_ == 0) return;
  for (unsigned bit = 0; bit < target.width; ++bit) {
    const Field one{static_cast<std::uint16_t>(target.base + bit), 1};
    if ((constant >> bit & 1U) != 0) combine_bits(std::bit_not(), one, one, {});
  }
}

}  // namespace csgsim::functional
