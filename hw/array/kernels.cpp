#include "hw/array/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hw/array/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <hwy/nanobenchmark.h>

HWY_BEFORE_NAMESPACE();
namespace csgsim::array::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Attributes of lambdas on vectors and of loops that call them. They must be inlined; otherwise vectors would be passed
// through memory. Under sanitizers a single inlined function would take minutes to compile.
#undef CSGSIM_BODY
#undef CSGSIM_LOOP
#ifdef CSGSIM_SANITIZED
#define CSGSIM_BODY HWY_ATTR
#define CSGSIM_LOOP HWY_ATTR
#else
#define CSGSIM_BODY HWY_ATTR __attribute__((always_inline))
#define CSGSIM_LOOP HWY_ATTR HWY_INLINE
#endif

using BlockTag = hn::CappedTag<std::uint64_t, block_words>;
using Vector = hn::Vec<BlockTag>;

constexpr unsigned max_bits = 64;  ///< length limit of a stream
alignas(64) constexpr std::uint64_t first_shifts[block_words] = {0, 1, 2, 3, 4, 5, 6, 7};

HWY_ATTR HWY_INLINE Vector load(const std::uint64_t* words) { return hn::Load(BlockTag(), words); }

HWY_ATTR HWY_INLINE void store(Vector value, std::uint64_t* words) { hn::Store(value, BlockTag(), words); }

/// a where the mask is 1, b elsewhere, bit by bit. IfVecThenElse would test whole bytes or words on targets with blend
/// instructions.
HWY_ATTR HWY_INLINE Vector select(Vector mask, Vector a, Vector b) {
#if HWY_TARGET <= HWY_AVX3
  return hn::IfVecThenElse(mask, a, b);
#else
  return hn::Xor(b, hn::And(mask, hn::Xor(a, b)));
#endif
}

HWY_ATTR HWY_INLINE Vector majority(Vector a, Vector b, Vector c) { return select(hn::Xor(a, b), c, a); }

/// The bits of yy*y*y + b*y as masks over pixels, where y is the row of each word of a block. If a block lies within
/// one row, all its words share the masks.
template <bool one_row>
struct RowMasks {
  alignas(64) std::uint64_t masks[one_row ? max_bits : max_bits * block_words];

  HWY_ATTR HWY_INLINE void set(const StreamTable& table, std::size_t first_word, std::size_t row_words) {
    if (one_row) {
      const std::uint64_t product = row_product(table, first_word / row_words);
      const BlockTag d;
      const Vector step = hn::Set(d, std::uint64_t{hn::Lanes(d)});
      const Vector low = hn::Set(d, std::uint64_t{1});
      const Vector all = hn::Set(d, product);
      Vector shift = hn::Load(d, first_shifts);
      for (unsigned bit = 0; bit < table.bits; bit += static_cast<unsigned>(hn::Lanes(d))) {
        store(hn::Sub(hn::Zero(d), hn::And(hn::Shr(all, shift), low)), masks + bit);
        shift = hn::Add(shift, step);
      }
      return;
    }
    alignas(64) std::uint64_t products[block_words];
    for (std::size_t word = 0; word < block_words; ++word)
      products[word] = row_product(table, (first_word + word) / row_words);
    const BlockTag d;
    const Vector low = hn::Set(d, std::uint64_t{1});
    for (std::size_t word = 0; word < block_words; word += hn::Lanes(d)) {
      Vector product = load(products + word);
      for (unsigned bit = 0; bit < table.bits; ++bit) {
        store(hn::Sub(hn::Zero(d), hn::And(product, low)), masks + bit * block_words + word);
        product = hn::ShiftRight<1>(product);
      }
    }
  }

  [[nodiscard]] HWY_ATTR HWY_INLINE Vector at(unsigned bit, std::size_t word) const {
    if (one_row) return hn::Set(BlockTag(), masks[bit]);
    return load(masks + bit * block_words + word);
  }

 private:
  static std::uint64_t row_product(const StreamTable& table, std::uint64_t y) { return (table.yy * y + table.b) * y; }
};

/// The bits of a stream with x*y at a vector of pixels: bit j is row j.
class CrossedBits {
 public:
  /// Not inlined, so that it does not slow down loops that do not use it.
  HWY_ATTR HWY_NOINLINE void set(const Stream& stream, std::size_t first_word, std::size_t row_words) {
    const BlockTag d;
    alignas(64) std::uint64_t values[block_words];
    alignas(64) std::uint64_t steps[block_words];  // differences to the next column
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
      const std::uint64_t x = (first_word + i) % row_words * word_bits;
      const std::uint64_t y = (first_word + i) / row_words;
      values[i] = value_at(stream, x, y);
      steps[i] = value_at(stream, x + 1, y) - values[i];
    }
    Vector value = load(values);
    Vector step = load(steps);
    const Vector second = hn::Set(d, 2 * stream.xx);
    for (std::size_t column = 0; column < word_bits; ++column) {
      store(value, at(column));
      value = hn::Add(value, step);
      step = hn::Add(step, second);
    }
    transpose();
  }

  [[nodiscard]] const std::uint64_t* rows() const { return rows_; }

 private:
  [[nodiscard]] std::uint64_t* at(std::size_t row) { return rows_ + row * block_words; }

  /// Transposes the 64 x 64 bits in each lane.
  HWY_ATTR HWY_INLINE void transpose() {
    transpose_by<32>(0x00000000ffffffff);
    transpose_by<16>(0x0000ffff0000ffff);
    transpose_by<8>(0x00ff00ff00ff00ff);
    transpose_by<4>(0x0f0f0f0f0f0f0f0f);
    transpose_by<2>(0x3333333333333333);
    transpose_by<1>(0x5555555555555555);
  }

  template <int distance>
  HWY_ATTR HWY_INLINE void transpose_by(std::uint64_t low) {
    const Vector mask = hn::Set(BlockTag(), low);
    for (std::size_t row = 0; row < word_bits; row = (row + distance + 1) & ~std::size_t{distance}) {
      const Vector upper = load(at(row));
      const Vector lower = load(at(row + distance));
      const Vector swapped = hn::And(hn::Xor(hn::ShiftRight<distance>(upper), lower), mask);
      store(hn::Xor(lower, swapped), at(row + distance));
      store(hn::Xor(upper, hn::ShiftLeft<distance>(swapped)), at(row));
    }
  }

  alignas(64) std::uint64_t rows_[max_bits * block_words];
};

/// The adders of the last tree levels: they deliver a stream's bits at a vector of pixels, one after another.
template <bool one_row>
class Adders {
 public:
  HWY_ATTR HWY_INLINE Adders(const RowMasks<one_row>& rows, const std::uint64_t* columns, std::size_t stride,
                             std::size_t word)
      : rows_(rows), columns_(columns), stride_(stride), word_(word) {}

  /// Advances the carry to a bit of the stream.
  HWY_ATTR HWY_INLINE void seek(unsigned bit, unsigned& next, Vector& carry) const {
    if (bit < next) {
      next = 0;
      carry = hn::Zero(BlockTag());
    }
    Vector c = carry;
    for (; next < bit; ++next) c = majority(column(next), rows_.at(next, word_), c);
    carry = c;
  }

  HWY_ATTR HWY_INLINE Vector take(unsigned bit, Vector& carry) const {
    const Vector x = column(bit);
    const Vector y = rows_.at(bit, word_);
    const Vector half = hn::Xor(x, y);
    const Vector sum = hn::Xor(half, carry);
    carry = select(half, carry, x);
    return sum;
  }

 private:
  [[nodiscard]] HWY_ATTR HWY_INLINE Vector column(unsigned bit) const {
    return hn::LoadU(BlockTag(), columns_ + bit * stride_);
  }

  const RowMasks<one_row>& rows_;
  const std::uint64_t* columns_;
  std::size_t stride_;
  std::size_t word_;
};

/// The registers of a vector of pixels, and the carry of the tree's adders there.
struct Registers {
  Vector enable;
  Vector carry;
  Vector flag;
  Vector tree_carry;
  unsigned next_bit;  ///< position in the stream
};

/// Calls body(i, x) for each step of a run, with its operand x.
template <bool one_row, class Body>
CSGSIM_LOOP void with_x(const Run& run, const Adders<one_row>& adders, std::uint64_t* bits, bool latch, Registers& r,
                        Body body) {
  if (run.from_tree) {
    adders.seek(run.stream_bit, r.next_bit, r.tree_carry);
    Vector carry = r.tree_carry;
    for (unsigned i = 0; i < run.count; ++i) body(i, adders.take(run.stream_bit + i, carry));
    r.tree_carry = carry;
    r.next_bit = run.stream_bit + run.count;
    return;
  }
  const std::uint64_t* x = bits + run.x * block_words;
  if (!run.latches || !latch) {
    for (unsigned i = 0; i < run.count; ++i) body(i, load(x + i * block_words));
    return;
  }
  Vector last = hn::Zero(BlockTag());
  for (unsigned i = 0; i < run.count; ++i) {
    last = load(x + i * block_words);
    body(i, last);
  }
  store(last, bits + PixelBits{}.latch(0) * block_words);
}

/// Executes a run on a vector of pixels. `bits` points to the vector's first word of bit 0. The flag is used only if
/// `with_flag`.
template <bool one_row, bool with_flag>
CSGSIM_LOOP void run_one(const Run& run, const Adders<one_row>& adders, std::uint64_t* bits,
                         const std::uint64_t* present, Effects effects, Registers& r) {
  const BlockTag d;
  const Vector zero = hn::Zero(d);
  const Vector ones = hn::Not(zero);
  Vector e = r.enable;
  Vector k = run.carry_in == CarryIn::keep ? r.carry : run.carry_in == CarryIn::one ? ones : zero;
  const std::uint64_t* const y = bits + run.y * block_words;
  std::uint64_t* const w = bits + run.write * block_words;
  const auto y_at = [&](unsigned i) CSGSIM_BODY { return load(y + i * block_words); };
  const auto constant = [&](unsigned i) CSGSIM_BODY { return hn::Set(d, 0 - (run.constant >> i & 1U)); };
  const auto put = [&](unsigned i, Vector mask, Vector value)
                       CSGSIM_BODY { store(select(mask, value, load(w + i * block_words)), w + i * block_words); };
  const auto each_x = [&](auto body) CSGSIM_BODY { with_x(run, adders, bits, effects.latch, r, body); };
  const auto on_enable = [&](auto f) CSGSIM_BODY { each_x([&](unsigned, Vector x) CSGSIM_BODY { e = f(e, x); }); };
  const auto put_of_x = [&](auto f)
                            CSGSIM_BODY { each_x([&](unsigned i, Vector x) CSGSIM_BODY { put(i, e, f(i, x)); }); };
  const auto sign = [&](auto then) CSGSIM_BODY {
    each_x([&](unsigned, Vector x) CSGSIM_BODY {
      k = hn::AndNot(x, k);
      then();
    });
  };
  switch (run.function) {
    case AluFunction::latch_x:
      if (effects.latch) each_x([&](unsigned i, Vector x) CSGSIM_BODY { store(x, w + i * block_words); });
      break;
    case AluFunction::enable_all: e = load(present); break;
    case AluFunction::enable_invert: e = hn::AndNot(e, load(present)); break;
    case AluFunction::enable_load: on_enable([](Vector, Vector x) CSGSIM_BODY { return x; }); break;
    case AluFunction::enable_and: on_enable([](Vector a, Vector x) CSGSIM_BODY { return hn::And(a, x); }); break;
    case AluFunction::enable_and_not: on_enable([](Vector a, Vector x) CSGSIM_BODY { return hn::AndNot(x, a); }); break;
    case AluFunction::enable_or: on_enable([](Vector a, Vector x) CSGSIM_BODY { return hn::Or(a, x); }); break;
    case AluFunction::enable_xor: on_enable([](Vector a, Vector x) CSGSIM_BODY { return hn::Xor(a, x); }); break;
    case AluFunction::enable_equal:
      each_x([&](unsigned i, Vector x) CSGSIM_BODY { e = hn::AndNot(hn::Xor(x, y_at(i)), e); });
      break;
    case AluFunction::compare:
      each_x([&](unsigned i, Vector x) CSGSIM_BODY { k = select(hn::Xor(x, y_at(i)), x, k); });
      break;
    case AluFunction::compare_with_0: each_x([&](unsigned, Vector x) CSGSIM_BODY { k = hn::Or(x, k); }); break;
    case AluFunction::less:
      each_x([&](unsigned i, Vector x) CSGSIM_BODY {
        k = select(hn::Xor(x, y_at(i)), x, k);
        e = hn::AndNot(k, e);
      });
      break;
    case AluFunction::sign_enable: sign([&]() CSGSIM_BODY { e = hn::And(e, k); }); break;
    case AluFunction::sign_enable_not: sign([&]() CSGSIM_BODY { e = hn::AndNot(k, e); }); break;
    case AluFunction::sign_select: sign([&]() CSGSIM_BODY { k = hn::And(e, k); }); break;
    case AluFunction::sign_select_not: sign([&]() CSGSIM_BODY { k = hn::AndNot(k, e); }); break;
    case AluFunction::enable_fits:
      each_x([&](unsigned, Vector x) CSGSIM_BODY { e = hn::AndNot(hn::And(k, x), e); });
      break;
    case AluFunction::store_x: put_of_x([](unsigned, Vector x) CSGSIM_BODY { return x; }); break;
    case AluFunction::store_x_selected: {
      const Vector mask = hn::And(e, k);
      each_x([&](unsigned i, Vector x) CSGSIM_BODY { put(i, mask, x); });
      break;
    }
    case AluFunction::store_not_x: put_of_x([](unsigned, Vector x) CSGSIM_BODY { return hn::Not(x); }); break;
    case AluFunction::store_constant:
      for (unsigned i = 0; i < run.count; ++i) put(i, e, constant(i));
      break;
    case AluFunction::store_xor_constant:
      put_of_x([&](unsigned i, Vector x) CSGSIM_BODY { return hn::Xor(x, constant(i)); });
      break;
    case AluFunction::store_and: put_of_x([&](unsigned i, Vector x) CSGSIM_BODY { return hn::And(x, y_at(i)); }); break;
    case AluFunction::store_or: put_of_x([&](unsigned i, Vector x) CSGSIM_BODY { return hn::Or(x, y_at(i)); }); break;
    case AluFunction::store_xor: put_of_x([&](unsigned i, Vector x) CSGSIM_BODY { return hn::Xor(x, y_at(i)); }); break;
    case AluFunction::store_and_not:
      put_of_x([&](unsigned i, Vector x) CSGSIM_BODY { return hn::AndNot(y_at(i), x); });
      break;
    case AluFunction::sum:
      each_x([&](unsigned i, Vector x) CSGSIM_BODY {
        const Vector added_to = y_at(i);
        const Vector half = hn::Xor(x, added_to);
        put(i, e, hn::Xor(half, k));
        k = select(half, k, x);
      });
      break;
    case AluFunction::sum_with_0:
      for (unsigned i = 0; i < run.count; ++i) {
        const Vector added_to = y_at(i);
        put(i, e, hn::Xor(added_to, k));
        k = hn::And(added_to, k);
      }
      break;
    case AluFunction::sum_with_1:
      for (unsigned i = 0; i < run.count; ++i) {
        const Vector added_to = y_at(i);
        put(i, e, hn::Not(hn::Xor(added_to, k)));
        k = hn::Or(added_to, k);
      }
      break;
    case AluFunction::difference:
      each_x([&](unsigned i, Vector x) CSGSIM_BODY {
        const Vector half = hn::Not(hn::Xor(x, y_at(i)));
        put(i, e, hn::Xor(half, k));
        k = select(half, k, x);
      });
      break;
    case AluFunction::root_first:
      if constexpr (!with_flag) break;
      for (unsigned i = 0; i < run.count; ++i) put(i, e, k);
      r.flag = hn::Not(k);
      break;
    case AluFunction::root_bit: {
      if constexpr (!with_flag) break;
      const Vector subtracts = hn::Not(r.flag);
      each_x([&](unsigned i, Vector x) CSGSIM_BODY {
        const Vector added_to = y_at(i);
        const Vector half = hn::Xor(hn::Xor(x, subtracts), added_to);
        put(i, e, hn::Xor(half, k));
        k = select(half, k, added_to);
      });
      break;
    }
    case AluFunction::root_sign:
      if constexpr (!with_flag) break;
      for (unsigned i = 0; i < run.count; ++i) {
        const Vector not_negative = hn::Xor(hn::Xor(y_at(i), r.flag), k);
        put(i, e, not_negative);
        r.flag = hn::Not(not_negative);
      }
      break;
    case AluFunction::store_enable:
      for (unsigned i = 0; i < run.count; ++i) store(e, w + i * block_words);
      break;
    case AluFunction::idle:
    case AluFunction::answer:
    case AluFunction::compare_from_0:
    case AluFunction::compare_from_1:
    case AluFunction::less_from_0:
    case AluFunction::less_from_1:
    case AluFunction::sum_from_0:
    case AluFunction::sum_with_1_from_0:
    case AluFunction::difference_from_1: break;  // no runs have these functions
  }
  r.enable = e;
  r.carry = k;
}

template <bool one_row, bool with_flag>
CSGSIM_LOOP void run_blocks(std::span<const Run> runs, std::span<const StreamTable> tables, const Blocks& blocks,
                            std::span<const std::uint32_t> numbers, Effects effects) {
  const BlockTag d;
  static constexpr StreamTable no_stream;
  RowMasks<one_row> rows;
  CrossedBits crossed;
  for (const std::uint32_t number : numbers) {
    const std::size_t first_word = number * block_words;
    const std::size_t column_word = first_word % blocks.row_words;
    for (std::size_t word = 0; word < block_words; word += hn::Lanes(d)) {
      std::uint64_t* const bits = blocks.bits + number * blocks.stride + word;
      std::uint64_t* const enable = blocks.enable + first_word + word;
      Registers r{.enable = effects.enabled ? load(enable) : hn::Zero(d),
                  .carry = load(bits + PixelBits::carry * block_words),
                  .flag = with_flag ? load(bits + PixelBits::flag * block_words) : hn::Zero(d),
                  .tree_carry = hn::Zero(d),
                  .next_bit = 0};
      const StreamTable* table = &no_stream;
      const std::uint64_t* columns = nullptr;
      std::size_t stride = 0;
      for (const Run& one : runs) {
        if (one.from_tree && table != &tables[one.stream]) {
          table = &tables[one.stream];
          rows.set(*table, first_word, blocks.row_words);
          if (table->crossed != nullptr) {
            crossed.set(*table->crossed, first_word + word, blocks.row_words);
            columns = crossed.rows();
            stride = block_words;
          } else {
            columns = table->columns + column_word + word;
            stride = table->stride;
          }
          r.next_bit = 0;
          r.tree_carry = hn::Zero(d);
        }
        run_one<one_row, with_flag>(one, Adders<one_row>(rows, columns, stride, word), bits,
                                    blocks.present + first_word + word, effects, r);
      }
      if (effects.enabled) store(r.enable, enable);
      if (effects.carry) store(r.carry, bits + PixelBits::carry * block_words);
      if (with_flag && effects.flag) store(r.flag, bits + PixelBits::flag * block_words);
    }
  }
}

void RunBlocks(std::span<const Run> runs, std::span<const StreamTable> tables, const Blocks& blocks,
               std::span<const std::uint32_t> numbers, Effects effects) {
  const bool one_row = blocks.row_words % block_words == 0;
  if (effects.has_flag) {
    return one_row ? run_blocks<true, true>(runs, tables, blocks, numbers, effects)
                   : run_blocks<false, true>(runs, tables, blocks, numbers, effects);
  }
  return one_row ? run_blocks<true, false>(runs, tables, blocks, numbers, effects)
                 : run_blocks<false, false>(runs, tables, blocks, numbers, effects);
}

/// Calls body(i) for the first word of every vector.
template <class Body>
HWY_ATTR HWY_INLINE void each(std::size_t words, Body body) {
  for (std::size_t i = 0; i < words; i += hn::Lanes(BlockTag())) body(i);
}

void FindOnes(const std::uint64_t* plane, std::span<std::uint8_t> flags) {
  const BlockTag d;
  for (std::size_t block = 0; block < flags.size(); ++block) {
    Vector any = hn::Zero(d);
    each(block_words, [&](std::size_t i) HWY_ATTR { any = hn::Or(any, load(plane + block * block_words + i)); });
    flags[block] = hn::AllTrue(d, hn::Eq(any, hn::Zero(d))) ? 0 : 1;
  }
}

std::uint64_t CountOnes(const std::uint64_t* plane, std::size_t words) {
  const BlockTag d;
  Vector count = hn::Zero(d);
  each(words, [&](std::size_t i) HWY_ATTR {
    const Vector bits = load(plane + i);
    if (!hn::AllTrue(d, hn::Eq(bits, hn::Zero(d)))) count = hn::Add(count, hn::PopulationCount(bits));
  });
  return hn::GetLane(hn::SumOfLanes(d, count));
}

bool AnyOnes(const std::uint64_t* plane, std::size_t words) {
  const BlockTag d;
  for (std::size_t i = 0; i < words; i += hn::Lanes(d)) {
    if (!hn::AllTrue(d, hn::Eq(load(plane + i), hn::Zero(d)))) return true;
  }
  return false;
}

}  // namespace csgsim::array::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgsim::array::kernels {

HWY_EXPORT(RunBlocks);
HWY_EXPORT(FindOnes);
HWY_EXPORT(CountOnes);
HWY_EXPORT(AnyOnes);

void run(std::span<const Run> runs, std::span<const StreamTable> tables, const Blocks& blocks,
         std::span<const std::uint32_t> block_numbers, Effects effects) {
  HWY_DYNAMIC_DISPATCH(RunBlocks)(runs, tables, blocks, block_numbers, effects);
}

void find_ones(const std::uint64_t* plane, std::span<std::uint8_t> flags) {
  HWY_DYNAMIC_DISPATCH(FindOnes)(plane, flags);
}

std::uint64_t count_ones(const std::uint64_t* plane, std::size_t word_count) {
  return HWY_DYNAMIC_DISPATCH(CountOnes)(plane, word_count);
}

bool any_ones(const std::uint64_t* plane, std::size_t word_count) {
  return HWY_DYNAMIC_DISPATCH(AnyOnes)(plane, word_count);
}

}  // namespace csgsim::array::kernels

/// Replaces a function of Highway, whose library measures the timer resolution at load time for benchmarks, which would
/// add 4 ms to each start. The dynamic linker prefers a program's function to a library's.
std::uint64_t hwy::platform::TimerResolution() { return 1; }
#endif
