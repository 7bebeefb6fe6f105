#include "hw/array/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hw/array/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace csgsim::array::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <std::size_t max_lanes>
using Tag = hn::CappedTag<std::uint64_t, max_lanes>;

/// Planes are whole cache lines, eight words.
using PlaneTag = Tag<8>;
using Vector = hn::Vec<PlaneTag>;

HWY_ATTR inline Vector majority(Vector a, Vector b, Vector c) {
  return hn::Or(hn::And(a, b), hn::And(c, hn::Or(a, b)));
}

HWY_ATTR inline Vector load(const std::uint64_t* plane, std::size_t i) { return hn::Load(PlaneTag(), plane + i); }

HWY_ATTR inline void store(Vector value, std::uint64_t* plane, std::size_t i) {
  hn::Store(value, PlaneTag(), plane + i);
}

/// Calls body(i) for the first word of every vector.
template <class Body>
HWY_ATTR inline void each(std::size_t words, Body body) {
  for (std::size_t i = 0; i < words; i += hn::Lanes(PlaneTag())) body(i);
}

/// E := f(E, x)
template <class F>
HWY_ATTR inline void enable_from_x(const AluPlanes& p, F f) {
  each(p.words, [&](std::size_t i) HWY_ATTR { store(f(load(p.enable, i), load(p.x, i)), p.enable, i); });
}

/// M[w] := value(i) where mask(i)
template <class Mask, class Value>
HWY_ATTR inline void store_where(const AluPlanes& p, Mask mask, Value value) {
  each(p.words, [&](std::size_t i) HWY_ATTR {
    const Vector m = mask(i);
    store(hn::Or(hn::And(m, value(i)), hn::AndNot(m, load(p.write, i))), p.write, i);
  });
}

/// K := carry of x - y; with `disable`, E := E and not K.
template <bool disable, class CarryIn>
HWY_ATTR inline void compare(const AluPlanes& p, CarryIn carry_in) {
  each(p.words, [&](std::size_t i) HWY_ATTR {
    const Vector carry = majority(load(p.x, i), hn::Not(load(p.y, i)), carry_in(i));
    store(carry, p.carry, i);
    if (disable) store(hn::AndNot(carry, load(p.enable, i)), p.enable, i);
  });
}

/// M[w] := x + y + K where E, K := its carry.
template <class X, class CarryIn>
HWY_ATTR inline void sum(const AluPlanes& p, X x, CarryIn carry_in) {
  each(p.words, [&](std::size_t i) HWY_ATTR {
    const Vector a = x(i);
    const Vector b = load(p.y, i);
    const Vector c = carry_in(i);
    const Vector enable = load(p.enable, i);
    store(majority(a, b, c), p.carry, i);
    store(hn::Or(hn::And(enable, hn::Xor(hn::Xor(a, b), c)), hn::AndNot(enable, load(p.write, i))), p.write, i);
  });
}

/// The step on the sign bit x: `plane` := E and (or and not) the comparison's result.
template <bool invert>
HWY_ATTR inline void sign(const AluPlanes& p, std::uint64_t* plane) {
  each(p.words, [&](std::size_t i) HWY_ATTR {
    const Vector result = hn::AndNot(load(p.x, i), load(p.carry, i));
    const Vector enable = load(p.enable, i);
    store(result, p.carry, i);
    store(invert ? hn::AndNot(result, enable) : hn::And(result, enable), plane, i);
  });
}

void AluStep(AluFunction function, const AluPlanes& p) {
  const PlaneTag d;
  const Vector zero = hn::Zero(d);
  const Vector ones = hn::Not(zero);
  const auto enable = [&](std::size_t i) HWY_ATTR { return load(p.enable, i); };
  const auto selected = [&](std::size_t i) HWY_ATTR { return hn::And(load(p.enable, i), load(p.carry, i)); };
  const auto carry = [&](std::size_t i) HWY_ATTR { return load(p.carry, i); };
  const auto always_0 = [&](std::size_t) HWY_ATTR { return zero; };
  const auto always_1 = [&](std::size_t) HWY_ATTR { return ones; };
  const auto x = [&](std::size_t i) HWY_ATTR { return load(p.x, i); };
  switch (function) {
    case AluFunction::idle:
    case AluFunction::answer: return;
    case AluFunction::latch_x: return each(p.words, [&](std::size_t i) HWY_ATTR { store(x(i), p.latch, i); });
    case AluFunction::enable_all:
      return each(p.words, [&](std::size_t i) HWY_ATTR { store(load(p.present, i), p.enable, i); });
    case AluFunction::enable_invert:
      return each(p.words,
                  [&](std::size_t i) HWY_ATTR { store(hn::AndNot(enable(i), load(p.present, i)), p.enable, i); });
    case AluFunction::enable_load: return each(p.words, [&](std::size_t i) HWY_ATTR { store(x(i), p.enable, i); });
    case AluFunction::enable_and: return enable_from_x(p, [](Vector e, Vector a) HWY_ATTR { return hn::And(e, a); });
    case AluFunction::enable_and_not:
      return enable_from_x(p, [](Vector e, Vector a) HWY_ATTR { return hn::AndNot(a, e); });
    case AluFunction::enable_or: return enable_from_x(p, [](Vector e, Vector a) HWY_ATTR { return hn::Or(e, a); });
    case AluFunction::enable_xor: return enable_from_x(p, [](Vector e, Vector a) HWY_ATTR { return hn::Xor(e, a); });
    case AluFunction::enable_equal:
      return each(p.words, [&](std::size_t i)
                               HWY_ATTR { store(hn::AndNot(hn::Xor(x(i), load(p.y, i)), enable(i)), p.enable, i); });
    case AluFunction::compare_from_0: return compare<false>(p, always_0);
    case AluFunction::compare_from_1: return compare<false>(p, always_1);
    case AluFunction::compare: return compare<false>(p, carry);
    case AluFunction::compare_with_0:
      return each(p.words, [&](std::size_t i) HWY_ATTR { store(hn::Or(x(i), carry(i)), p.carry, i); });
    case AluFunction::less_from_0: return compare<true>(p, always_0);
    case AluFunction::less_from_1: return compare<true>(p, always_1);
    case AluFunction::less: return compare<true>(p, carry);
    case AluFunction::sign_enable: return sign<false>(p, p.enable);
    case AluFunction::sign_enable_not: return sign<true>(p, p.enable);
    case AluFunction::sign_select: return sign<false>(p, p.carry);
    case AluFunction::sign_select_not: return sign<true>(p, p.carry);
    case AluFunction::enable_fits:
      return each(p.words,
                  [&](std::size_t i) HWY_ATTR { store(hn::AndNot(hn::And(carry(i), x(i)), enable(i)), p.enable, i); });
    case AluFunction::store_x: return store_where(p, enable, x);
    case AluFunction::store_x_selected: return store_where(p, selected, x);
    case AluFunction::store_not_x: return store_where(p, enable, [&](std::size_t i) HWY_ATTR { return hn::Not(x(i)); });
    case AluFunction::store_constant:
      return p.constant ? store_where(p, enable, always_1) : store_where(p, enable, always_0);
    case AluFunction::store_xor_constant:
      return AluStep(p.constant ? AluFunction::store_not_x : AluFunction::store_x, p);
    case AluFunction::store_and:
      return store_where(p, enable, [&](std::size_t i) HWY_ATTR { return hn::And(x(i), load(p.y, i)); });
    case AluFunction::store_or:
      return store_where(p, enable, [&](std::size_t i) HWY_ATTR { return hn::Or(x(i), load(p.y, i)); });
    case AluFunction::store_xor:
      return store_where(p, enable, [&](std::size_t i) HWY_ATTR { return hn::Xor(x(i), load(p.y, i)); });
    case AluFunction::store_and_not:
      return store_where(p, enable, [&](std::size_t i) HWY_ATTR { return hn::AndNot(load(p.y, i), x(i)); });
    case AluFunction::sum_from_0: return sum(p, x, always_0);
    case AluFunction::sum: return sum(p, x, carry);
    case AluFunction::sum_with_0: return sum(p, always_0, carry);
    case AluFunction::store_enable: return each(p.words, [&](std::size_t i) HWY_ATTR { store(enable(i), p.write, i); });
  }
}

/// One vector of a node: the stream to the left child, its sum with the multiplicand and the carry to the right.
template <bool first, bool multiplicand, class D>
HWY_ATTR inline void node_step(D d, const std::uint64_t* in, std::uint64_t* carry, std::uint64_t* left,
                               std::uint64_t* right) {
  const auto v = hn::LoadU(d, in);
  hn::StoreU(v, d, left);
  if (first) {
    hn::StoreU(multiplicand ? hn::Not(v) : v, d, right);
    hn::StoreU(multiplicand ? v : hn::Zero(d), d, carry);
  } else {
    const auto c = hn::LoadU(d, carry);
    const auto half = hn::Xor(v, c);
    hn::StoreU(multiplicand ? hn::Not(half) : half, d, right);
    hn::StoreU(multiplicand ? hn::Or(v, c) : hn::And(v, c), d, carry);
  }
}

/// `row` words a node, a multiple of the lanes.
template <bool first, bool multiplicand, class D>
HWY_ATTR HWY_INLINE void nodes_step(D d, const TreeLevel& level, std::size_t row) {
  const TreeLevel l = level;  // a copy of its own, which the stores below cannot change
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t p = 0; p < l.right_children; ++p) {
    for (std::size_t i = 0; i < row; i += lanes) {
      std::uint64_t* left = l.out + 2 * p * row + i;
      node_step<first, multiplicand>(d, l.in + p * row + i, l.carry + p * row + i, left, left + row);
    }
  }
  if (l.right_children == l.nodes) return;
  const std::size_t p = l.right_children;
  for (std::size_t i = 0; i < row; ++i) l.out[2 * p * row + i] = l.in[p * row + i];
}

/// A row that is one vector gets a loop of its own.
template <bool first, bool multiplicand, class D>
HWY_ATTR inline void rows_step(D d, const TreeLevel& level) {
  if (level.row_words == hn::MaxLanes(d)) return nodes_step<first, multiplicand>(d, level, hn::MaxLanes(d));
  return nodes_step<first, multiplicand>(d, level, level.row_words);
}

template <std::size_t max_lanes>
HWY_ATTR inline void level_step(const TreeLevel& level, bool first, bool multiplicand) {
  const Tag<max_lanes> d;
  if (first) return multiplicand ? rows_step<true, true>(d, level) : rows_step<true, false>(d, level);
  return multiplicand ? rows_step<false, true>(d, level) : rows_step<false, false>(d, level);
}

void TreeLevelStep(const TreeLevel& level, bool first, bool multiplicand) {
  if (level.row_words % 8 == 0) return level_step<8>(level, first, multiplicand);
  if (level.row_words % 4 == 0) return level_step<4>(level, first, multiplicand);
  if (level.row_words % 2 == 0) return level_step<2>(level, first, multiplicand);
  return level_step<1>(level, first, multiplicand);
}

std::uint64_t CountOnes(const std::uint64_t* plane, std::size_t words) {
  Vector count = hn::Zero(PlaneTag());
  each(words, [&](std::size_t i) HWY_ATTR { count = hn::Add(count, hn::PopulationCount(load(plane, i))); });
  return hn::GetLane(hn::SumOfLanes(PlaneTag(), count));
}

bool AnyOnes(const std::uint64_t* plane, std::size_t words) {
  const PlaneTag d;
  for (std::size_t i = 0; i < words; i += hn::Lanes(d)) {
    if (!hn::AllTrue(d, hn::Eq(load(plane, i), hn::Zero(d)))) return true;
  }
  return false;
}

}  // namespace csgsim::array::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgsim::array::kernels {

HWY_EXPORT(AluStep);
HWY_EXPORT(TreeLevelStep);
HWY_EXPORT(CountOnes);
HWY_EXPORT(AnyOnes);

void alu_step(AluFunction function, const AluPlanes& planes) { HWY_DYNAMIC_DISPATCH(AluStep)(function, planes); }

void tree_level_step(const TreeLevel& level, bool first, bool multiplicand) {
  HWY_DYNAMIC_DISPATCH(TreeLevelStep)(level, first, multiplicand);
}

std::uint64_t count_ones(const std::uint64_t* plane, std::size_t words) {
  return HWY_DYNAMIC_DISPATCH(CountOnes)(plane, words);
}

bool any_ones(const std::uint64_t* plane, std::size_t words) { return HWY_DYNAMIC_DISPATCH(AnyOnes)(plane, words); }

}  // namespace csgsim::array::kernels
#endif
