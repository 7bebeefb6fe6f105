#include "tests/performance/dense_loop.h"

#include <algorithm>
#include <utility>

#include "hw/base/address_sanitizer.h"
#include "hw/isa/opcodes.h"

// Uses the widest vectors of the computer, like the kernels of the clocked engine.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !CSGSIM_ADDRESS_SANITIZER
#define CSGSIM_WIDEST __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define CSGSIM_WIDEST
#endif

namespace csgsim::bench {

namespace {

namespace kernels = array::kernels;
using array::AluFunction;
using Word = std::uint64_t;

constexpr std::size_t word_bits = 64;

constexpr Word majority(Word a, Word b, Word c) { return (a & b) | (c & (a | b)); }

/// A bit of the columns' partial sum in each word of a row, and the bit added by the rows.
struct TreeBit {
  const Word* columns;
  Word b;
  Word yy;
  unsigned bit;
  std::size_t row_words;
  std::size_t rows;
};

template <std::size_t fixed_words>
inline __attribute__((always_inline)) void add_each_row(const TreeBit& in, Word* __restrict sum,
                                                        Word* __restrict carry) {
  const std::size_t length = fixed_words == 0 ? in.row_words : fixed_words;
  for (std::size_t y = 0; y < in.rows; ++y) {
    const Word row = 0 - ((in.yy * y + in.b) * y >> in.bit & 1U);
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t at = y * length + i;
      const Word c = carry[at];
      sum[at] = in.columns[i] ^ row ^ c;
      carry[at] = majority(in.columns[i], row, c);
    }
  }
}

/// Rows of 512 pixels have a separate loop.
CSGSIM_WIDEST void add_rows(const TreeBit& in, Word* sum, Word* carry) {
  if (in.row_words == 8) return add_each_row<8>(in, sum, carry);
  add_each_row<0>(in, sum, carry);
}

/// Operands of a step for all pixels: sources, destinations, registers.
struct Operands {
  const Word* x;
  const Word* y;
  Word* m;
  Word* e;
  Word* k;
  Word* g;
  Word* latch;
  const Word* p;
  Word constant;
  std::size_t words;
};

/// The operations of hw/array/array_step.h, word by word.
CSGSIM_WIDEST void carry_out(AluFunction function, const Operands& operands) {
  const Word* const x = operands.x;
  const Word* const y = operands.y;
  const Word* const p = operands.p;
  Word* const m = operands.m;
  Word* const e = operands.e;
  Word* const k = operands.k;
  Word* const g = operands.g;
  Word* const latch = operands.latch;
  const Word constant = operands.constant;
  const auto every = [words = operands.words](auto word) {
    for (std::size_t i = 0; i < words; ++i) word(i);
  };
  const auto put = [&](std::size_t i, Word value, Word where) { m[i] = (m[i] & ~where) | (value & where); };
  const auto add = [&](std::size_t i, Word a, Word b, Word c) {
    const Word carry = majority(a, b, c);
    put(i, a ^ b ^ c, e[i]);
    k[i] = carry;
  };
  const auto decide = [&](std::size_t i, Word carry) {
    k[i] = carry;
    e[i] &= ~carry;
  };
  switch (function) {
    case AluFunction::idle:
    case AluFunction::answer: break;
    case AluFunction::latch_x: every([&](std::size_t i) { latch[i] = x[i]; }); break;
    case AluFunction::enable_all: every([&](std::size_t i) { e[i] = p[i]; }); break;
    case AluFunction::enable_invert: every([&](std::size_t i) { e[i] = p[i] & ~e[i]; }); break;
    case AluFunction::enable_load: every([&](std::size_t i) { e[i] = x[i] & p[i]; }); break;
    case AluFunction::enable_and: every([&](std::size_t i) { e[i] &= x[i]; }); break;
    case AluFunction::enable_and_not: every([&](std::size_t i) { e[i] &= ~x[i]; }); break;
    case AluFunction::enable_or: every([&](std::size_t i) { e[i] |= x[i] & p[i]; }); break;
    case AluFunction::enable_xor: every([&](std::size_t i) { e[i] ^= x[i] & p[i]; }); break;
    case AluFunction::enable_equal: every([&](std::size_t i) { e[i] &= ~(x[i] ^ y[i]); }); break;
    case AluFunction::compare_from_0: every([&](std::size_t i) { k[i] = x[i] & ~y[i]; }); break;
    case AluFunction::compare_from_1: every([&](std::size_t i) { k[i] = x[i] | ~y[i]; }); break;
    case AluFunction::compare: every([&](std::size_t i) { k[i] = majority(x[i], ~y[i], k[i]); }); break;
    case AluFunction::compare_with_0: every([&](std::size_t i) { k[i] |= x[i]; }); break;
    case AluFunction::less_from_0: every([&](std::size_t i) { decide(i, x[i] & ~y[i]); }); break;
    case AluFunction::less_from_1: every([&](std::size_t i) { decide(i, x[i] | ~y[i]); }); break;
    case AluFunction::less: every([&](std::size_t i) { decide(i, majority(x[i], ~y[i], k[i])); }); break;
    case AluFunction::sign_enable: every([&](std::size_t i) { e[i] &= k[i] &= ~x[i]; }); break;
    case AluFunction::sign_enable_not: every([&](std::size_t i) { decide(i, ~x[i] & k[i]); }); break;
    case AluFunction::sign_select: every([&](std::size_t i) { k[i] &= e[i] & ~x[i]; }); break;
    case AluFunction::sign_select_not: every([&](std::size_t i) { k[i] = e[i] & ~(~x[i] & k[i]); }); break;
    case AluFunction::enable_fits: every([&](std::size_t i) { e[i] &= ~(k[i] & x[i]); }); break;
    case AluFunction::store_x: every([&](std::size_t i) { put(i, x[i], e[i]); }); break;
    case AluFunction::store_x_selected: every([&](std::size_t i) { put(i, x[i], e[i] & k[i]); }); break;
    case AluFunction::store_not_x: every([&](std::size_t i) { put(i, ~x[i], e[i]); }); break;
    case AluFunction::store_constant: every([&](std::size_t i) { put(i, constant, e[i]); }); break;
    case AluFunction::store_xor_constant: every([&](std::size_t i) { put(i, x[i] ^ constant, e[i]); }); break;
    case AluFunction::store_and: every([&](std::size_t i) { put(i, x[i] & y[i], e[i]); }); break;
    case AluFunction::store_or: every([&](std::size_t i) { put(i, x[i] | y[i], e[i]); }); break;
    case AluFunction::store_xor: every([&](std::size_t i) { put(i, x[i] ^ y[i], e[i]); }); break;
    case AluFunction::store_and_not: every([&](std::size_t i) { put(i, x[i] & ~y[i], e[i]); }); break;
    case AluFunction::sum_from_0: every([&](std::size_t i) { add(i, x[i], y[i], 0); }); break;
    case AluFunction::sum: every([&](std::size_t i) { add(i, x[i], y[i], k[i]); }); break;
    case AluFunction::sum_with_0: every([&](std::size_t i) { add(i, 0, y[i], k[i]); }); break;
    case AluFunction::sum_with_1_from_0: every([&](std::size_t i) { add(i, ~Word{0}, y[i], 0); }); break;
    case AluFunction::sum_with_1: every([&](std::size_t i) { add(i, ~Word{0}, y[i], k[i]); }); break;
    case AluFunction::difference_from_1: every([&](std::size_t i) { add(i, x[i], ~y[i], ~Word{0}); }); break;
    case AluFunction::difference: every([&](std::size_t i) { add(i, x[i], ~y[i], k[i]); }); break;
    case AluFunction::root_first:
      every([&](std::size_t i) {
        g[i] = ~k[i];
        put(i, k[i], e[i]);
      });
      break;
    case AluFunction::root_bit: every([&](std::size_t i) { add(i, x[i] ^ ~g[i], y[i], k[i]); }); break;
    case AluFunction::root_sign:
      every([&](std::size_t i) {
        g[i] = y[i] ^ ~g[i] ^ k[i];
        put(i, ~g[i], e[i]);
      });
      break;
    case AluFunction::store_enable: every([&](std::size_t i) { m[i] = e[i]; }); break;
  }
}

}  // namespace

DenseLoop::DenseLoop(const isa::ArrayShape& shape)
    : row_words_((shape.width + word_bits - 1) / word_bits),
      height_(shape.height),
      sequencer_(1, 1, 1),
      memory_(shape.memory_bits, Plane(row_words_ * height_)),
      present_(row_words_ * height_),
      enable_(present_.size()),
      carry_(present_.size()),
      flag_(present_.size()),
      latch_(present_.size()),
      tree_(present_.size()),
      tree_carry_(present_.size()),
      columns_({shape.width, shape.height}, {}) {}

bool DenseLoop::memory_bit(std::uint32_t address, std::uint32_t x, std::uint32_t y) const {
  return (memory_[address][y * row_words_ + x / word_bits] >> (x % word_bits) & 1U) != 0;
}

bool DenseLoop::enabled(std::uint32_t x, std::uint32_t y) const {
  return (enable_[y * row_words_ + x / word_bits] >> (x % word_bits) & 1U) != 0;
}

bool DenseLoop::any_enabled() const {
  return std::any_of(enable_.begin(), enable_.end(), [](Word word) { return word != 0; });
}

std::uint64_t DenseLoop::run(const isa::Segment& segment) {
  for (Plane& plane : memory_) std::fill(plane.begin(), plane.end(), 0);
  for (Plane* plane : {&present_, &enable_, &carry_, &flag_, &latch_}) std::fill(plane->begin(), plane->end(), 0);
  for (std::uint32_t y = 0; y < segment.region.height; ++y) {
    for (std::uint32_t x = 0; x < segment.region.width; ++x)
      present_[y * row_words_ + x / word_bits] |= Word{1} << (x % word_bits);
  }
  std::uint64_t steps = 0;
  for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
    const isa::Instruction& instruction = segment.instructions[i];
    steps += execute(instruction);
    if (instruction.opcode == isa::Opcode::skip_if_none && !any_enabled()) i += instruction.constant;
  }
  return steps;
}

std::uint64_t DenseLoop::execute(const isa::Instruction& instruction) {
  const isa::Linear& linear = instruction.linear;
  sequencer_.begin(instruction);
  const isa::Linear& squares = sequencer_.squares();
  const array::Stream stream{.a = static_cast<Word>(linear.a),
                             .b = static_cast<Word>(linear.b),
                             .c = static_cast<Word>(linear.c),
                             .xx = static_cast<Word>(squares.a),
                             .xy = static_cast<Word>(squares.b),
                             .yy = static_cast<Word>(squares.c),
                             .bits = linear.width};
  kernels::StreamTable columns;
  if (linear.width > 0) columns = columns_.compute_tables({&stream, 1}).front();
  std::uint64_t steps = 0;
  for (; sequencer_.busy(); ++steps) {
    const array::BitStep step = sequencer_.issue();
    if (step.root.token.active()) tree_bit(columns, static_cast<unsigned>(step.root.token.bit));
    alu_step(step.pixels);
  }
  return steps;
}

/// The adders' carry is cleared at bit 0, and propagates from bit to bit.
void DenseLoop::tree_bit(const kernels::StreamTable& columns, unsigned bit) {
  if (columns.crossed != nullptr) return crossed_bit(*columns.crossed, bit);
  if (bit == 0) std::fill(tree_carry_.begin(), tree_carry_.end(), 0);
  add_rows({columns.columns + bit * columns.stride, columns.b, columns.yy, bit, row_words_, height_}, tree_.data(),
           tree_carry_.data());
}

/// For x*y the columns have no common part.
void DenseLoop::crossed_bit(const array::Stream& stream, unsigned bit) {
  for (std::size_t word = 0; word < tree_.size(); ++word) {
    Word bits = 0;
    for (std::size_t i = 0; i < word_bits; ++i) {
      const std::uint64_t value = array::value_at(stream, word % row_words_ * word_bits + i, word / row_words_);
      bits |= (value >> bit & 1U) << i;
    }
    tree_[word] = bits;
  }
}

void DenseLoop::alu_step(const array::ArrayStep& step) {
  const AluFunction function = array::function_of_bit(step, 0);
  const array::AluInfo& row = array::info(function);
  const Plane& from = step.source == array::OperandSource::tree    ? tree_
                      : step.source == array::OperandSource::latch ? latch_
                                                                   : memory_[step.x];
  carry_out(function, {.x = from.data(),
                       .y = row.reads_y ? memory_[step.y].data() : nullptr,
                       .m = row.writes ? memory_[step.write].data() : nullptr,
                       .e = enable_.data(),
                       .k = carry_.data(),
                       .g = flag_.data(),
                       .latch = latch_.data(),
                       .p = present_.data(),
                       .constant = 0 - (step.constant & Word{1}),
                       .words = enable_.size()});
}

}  // namespace csgsim::bench
