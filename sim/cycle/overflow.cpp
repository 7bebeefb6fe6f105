#include "sim/cycle/overflow.h"

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <vector>

#include "hw/isa/operands.h"

namespace csgsim::cycle {

namespace {

__extension__ using Wide = __int128;

constexpr std::uint32_t word_bits = 64;

/// A rectangle of pixels, including the last column and row.
struct Box {
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  std::uint32_t top = 0;
  std::uint32_t bottom = 0;
};

struct Range {
  Wide least = 0;
  Wide greatest = 0;
};

Range operator+(const Range& one, const Range& other) {
  return {one.least + other.least, one.greatest + other.greatest};
}

Range make_range(std::initializer_list<Wide> values) {
  const auto [least, greatest] = std::minmax(values);
  return {least, greatest};
}

/// Range of square*i*i + slope*i, whose extremes are at the ends or next to the vertex.
Range parabola(std::int64_t square, std::int64_t slope, std::uint32_t first, std::uint32_t last) {
  const auto at = [&](Wide i) { return (square * i + slope) * i; };
  const Range ends = make_range({at(first), at(last)});
  if (square == 0) return ends;
  const auto within = [&](Wide i) { return std::clamp<Wide>(i, first, last); };
  const Wide vertex = -static_cast<Wide>(slope) / (2 * static_cast<Wide>(square));
  return make_range({ends.least, ends.greatest, at(within(vertex - 1)), at(within(vertex)), at(within(vertex + 1))});
}

/// Bounds of the sum: those of its parts in x, in y and in both. They are exact for a single row.
Range bounds(const Expression& expression, const Box& box) {
  const isa::Linear& linear = expression.linear;
  const isa::Linear& squares = expression.squares;
  const auto cross = [&](std::uint32_t x, std::uint32_t y) { return static_cast<Wide>(squares.b) * x * y; };
  if (box.top == box.bottom) {
    const Wide y = box.top;
    const auto slope = static_cast<std::int64_t>(linear.a + squares.b * y);
    const Wide row = (squares.c * y + linear.b) * y + linear.c;
    return parabola(squares.a, slope, box.left, box.right) + Range{row, row};
  }
  return parabola(squares.a, linear.a, box.left, box.right) + parabola(squares.c, linear.b, box.top, box.bottom) +
         make_range({cross(box.left, box.top), cross(box.right, box.top), cross(box.left, box.bottom),
                     cross(box.right, box.bottom)}) +
         Range{linear.c, linear.c};
}

bool fits(const isa::Linear& linear, std::uint32_t x, std::uint32_t y) {
  const Wide sum = static_cast<Wide>(linear.a) * x + static_cast<Wide>(linear.b) * y + linear.c;
  const Wide half = static_cast<Wide>(1) << (linear.width - 1U);
  return -half <= sum && sum < half;
}

/// Whether the sum certainly fits at all pixels of the box. Without squares, its extremes are at the corners.
bool fits(const Expression& expression, const Box& box) {
  const isa::Linear& linear = expression.linear;
  if (expression.squares.width == 0)
    return fits(linear, box.left, box.top) && fits(linear, box.right, box.top) && fits(linear, box.left, box.bottom) &&
           fits(linear, box.right, box.bottom);
  const Range range = bounds(expression, box);
  const Wide half = static_cast<Wide>(1) << (linear.width - 1U);
  return -half <= range.least && range.greatest < half;
}

/// The bounding box of the bits set in rows of words; empty if none is set.
std::optional<Box> box_around(std::span<const std::uint64_t> enable, std::size_t row_words, std::uint32_t height) {
  std::vector<std::uint64_t> columns(row_words);
  std::optional<Box> box;
  for (std::uint32_t y = 0; y < height; ++y) {
    std::uint64_t any = 0;
    for (std::size_t word = 0; word < row_words; ++word) {
      const std::uint64_t bits = enable[y * row_words + word];
      any |= bits;
      columns[word] |= bits;
    }
    if (any == 0) continue;
    if (!box) box = Box{.top = y};
    box->bottom = y;
  }
  if (!box) return std::nullopt;
  std::uint32_t first = 0;
  while (columns[first] == 0) ++first;
  auto last = static_cast<std::uint32_t>(row_words) - 1;
  while (columns[last] == 0) --last;
  box->left = first * word_bits + static_cast<std::uint32_t>(std::countr_zero(columns[first]));
  box->right = last * word_bits + word_bits - 1 - static_cast<std::uint32_t>(std::countl_zero(columns[last]));
  return box;
}

std::uint64_t count_in_row(const Expression& expression, std::uint32_t y, std::span<const std::uint64_t> row) {
  std::uint64_t count = 0;
  for (std::uint32_t word = 0; word < row.size(); ++word) {
    for (std::uint64_t bits = row[word]; bits != 0; bits &= bits - 1) {
      const std::uint32_t x = word * word_bits + static_cast<std::uint32_t>(std::countr_zero(bits));
      const bool has_squares = expression.squares.width != 0;
      if (has_squares ? !fits(expression, Box{x, x, y, y}) : !fits(expression.linear, x, y)) ++count;
    }
  }
  return count;
}

}  // namespace

std::optional<Expression> find_expression(const isa::Segment& segment, std::size_t index) {
  if (index >= segment.instructions.size()) return std::nullopt;
  const isa::Instruction& instruction = segment.instructions[index];
  const bool has_sum = isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear);
  if (!has_sum || isa::may_exceed_width(instruction.opcode)) return std::nullopt;
  const isa::Instruction* const squares = isa::pending_squares(segment, index);
  return Expression{instruction.linear, squares == nullptr ? isa::Linear{} : squares->linear};
}

bool can_overflow(const Expression& expression, const isa::Region& region) {
  return !fits(expression, Box{0, region.width - 1, 0, region.height - 1});
}

std::uint64_t count_overflows(const Expression& expression, const isa::Region& region,
                              std::span<const std::uint64_t> enable, std::size_t row_words) {
  if (!can_overflow(expression, region)) return 0;
  const std::optional<Box> box = box_around(enable, row_words, region.height);
  if (!box || fits(expression, *box)) return 0;
  std::uint64_t count = 0;
  for (std::uint32_t y = box->top; y <= box->bottom; ++y) {
    if (fits(expression, Box{box->left, box->right, y, y})) continue;
    count += count_in_row(expression, y, enable.subspan(y * row_words, row_words));
  }
  return count;
}

}  // namespace csgsim::cycle
