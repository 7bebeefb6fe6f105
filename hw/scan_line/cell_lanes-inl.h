// Included once per instruction set, as Highway requires: no plain include guard.
#if defined(CSGSIM_CELL_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGSIM_CELL_LANES_INL_H
#undef CSGSIM_CELL_LANES_INL_H
#else
#define CSGSIM_CELL_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "hw/isa/instruction.h"
#include "hw/isa/opcodes.h"
#include "hw/scan_line/cell_kernels.h"

/// Vector operations for the loops over cells.
HWY_BEFORE_NAMESPACE();
namespace csgsim::scan_line::kernels {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<std::uint64_t, max_lanes>;
using Vector = hn::Vec<Tag>;

constexpr std::uint32_t lane_bits = 64;

/// Word with the low `bits` bits set; `bits` is below 64.
constexpr std::uint64_t ones(std::uint32_t bits) { return (std::uint64_t{1} << bits) - 1; }

HWY_INLINE Vector set(std::uint64_t number) { return hn::Set(Tag(), number); }
HWY_INLINE Vector left(Vector value, std::uint32_t bits) { return hn::ShiftLeftSame(value, static_cast<int>(bits)); }
HWY_INLINE Vector right(Vector value, std::uint32_t bits) { return hn::ShiftRightSame(value, static_cast<int>(bits)); }

/// Bit `from` of each number, as 0 or 1.
template <int from>
HWY_INLINE Vector bit(Vector value) {
  return hn::And(hn::ShiftRight<from>(value), set(1));
}

/// Copies a number that is 0 or 1 to all bits.
HWY_INLINE Vector spread(Vector bit_of) { return hn::Sub(hn::Zero(Tag()), bit_of); }

/// 1 for any nonzero number, otherwise 0.
HWY_INLINE Vector any(Vector value) { return hn::IfThenElseZero(hn::Ne(value, hn::Zero(Tag())), set(1)); }

HWY_INLINE Vector select(Vector mask, Vector a, Vector b) { return hn::Xor(b, hn::And(mask, hn::Xor(a, b))); }

/// A vector of cells starting at `first`; `left` cells of the range remain, including these.
struct Place {
  std::size_t first;
  std::size_t left;

  [[nodiscard]] HWY_INLINE bool whole() const { return left >= hn::Lanes(Tag()); }
  /// The value, with zeros in lanes beyond the range.
  [[nodiscard]] HWY_INLINE Vector inside(Vector value) const {
    return whole() ? value : hn::IfThenElseZero(hn::FirstN(Tag(), left), value);
  }
};

HWY_INLINE Vector load(const std::uint64_t* lanes, Place at) { return hn::LoadU(Tag(), lanes + at.first); }

HWY_INLINE void store(Vector value, std::uint64_t* lanes, Place at) {
  if (at.whole()) {
    hn::StoreU(value, Tag(), lanes + at.first);
  } else {
    hn::BlendedStore(value, hn::FirstN(Tag(), at.left), Tag(), lanes + at.first);
  }
}

/// Calls body(place) for every vector of the range.
template <class Body>
HWY_ATTR HWY_INLINE void each(CellRange range, const Body& body) {
  for (std::size_t first = range.first; first < range.end; first += hn::Lanes(Tag()))
    body(Place{first, range.end - first});
}

/// Values of F in consecutive cells, as computed by the adders.
class Expression {
 public:
  HWY_INLINE Expression(const Packet& packet, std::uint32_t first)
      : unused_(lane_bits - std::max<std::uint32_t>(packet.instruction.linear.width, 1)),
        shift_(std::min(unused_ + packet.instruction.linear.shift, lane_bits - 1)) {
    const isa::Linear& linear = packet.instruction.linear;
    const auto a = static_cast<std::uint64_t>(linear.a);
    const auto c = static_cast<std::uint64_t>(linear.c);
    const auto square = static_cast<std::uint64_t>(packet.square);
    const std::uint64_t count = hn::Lanes(Tag());
    HWY_ALIGN std::uint64_t sums[max_lanes];
    HWY_ALIGN std::uint64_t steps[max_lanes];
    for (std::uint64_t lane = 0; lane < count; ++lane) {
      const std::uint64_t x = first + lane;
      sums[lane] = (square * x + a) * x + c;
      steps[lane] = (square * (2 * x + count) + a) * count;
    }
    sum_ = hn::Load(Tag(), sums);
    step_ = hn::Load(Tag(), steps);
    second_ = set(2 * square * count * count);
  }

  /// F in the cells of the next vector, in two's complement.
  HWY_INLINE Vector next() {
    constexpr hn::RebindToSigned<Tag> with_sign;
    const auto high = hn::BitCast(with_sign, left(sum_, unused_));
    sum_ = hn::Add(sum_, step_);
    step_ = hn::Add(step_, second_);
    return hn::BitCast(Tag(), hn::ShiftRightSame(high, static_cast<int>(shift_)));
  }

 private:
  std::uint32_t unused_;
  std::uint32_t shift_;
  Vector sum_;
  Vector step_;
  Vector second_;
};

/// A field that was read, as an operand; 0 if the packet does not read it.
class Source {
 public:
  HWY_INLINE Source(const Packet& packet, const Lanes& lanes, std::size_t number)
      : fetched_(packet.accesses.sources[number].count > 0 ? lanes.fetched[number] : nullptr) {}
  [[nodiscard]] HWY_INLINE Vector at(Place place) const {
    return fetched_ == nullptr ? hn::Zero(Tag()) : load(fetched_, place);
  }

 private:
  const std::uint64_t* fetched_;
};

/// Operands of the ALU, vector by vector. If the packet has F, F is the first operand; a constant is the second
/// operand.
class Operands {
 public:
  HWY_INLINE Operands(const Packet& packet, const Lanes& lanes, CellRange range)
      : has_f_(packet.brings_f()),
        has_constant_(packet.instruction.opcode == isa::Opcode::xor_constant),
        f_(packet, range.first),
        first_(packet, lanes, 0),
        second_(packet, lanes, 1),
        constant_(set(packet.instruction.constant)) {}

  HWY_INLINE Vector x(Place at) { return has_f_ ? f_.next() : first_.at(at); }
  [[nodiscard]] HWY_INLINE Vector y(Place at) const {
    if (has_f_) return first_.at(at);
    return has_constant_ ? constant_ : second_.at(at);
  }

 private:
  bool has_f_;
  bool has_constant_;
  Expression f_;
  Source first_;
  Source second_;
  Vector constant_;
};

/// Bits of a field that lie in one 64-bit word or in two adjacent words.
HWY_INLINE Vector bits_at(const Lanes& lanes, isa::Field bits, Place at) {
  const std::uint64_t* const words = lanes.memory + bits.base / lane_bits * lanes.stride;
  const std::uint32_t shift = bits.base % lane_bits;
  Vector value = right(load(words, at), shift);
  if (shift + bits.width > lane_bits) value = hn::Or(value, left(load(words + lanes.stride, at), lane_bits - shift));
  return hn::And(value, set(ones(bits.width)));
}

HWY_INLINE void blend(std::uint64_t* words, Vector value, Vector mask, Place at) {
  store(select(mask, value, load(words, at)), words, at);
}

/// Writes the low bits of the value where the mask is all ones.
HWY_INLINE void put_bits(const Lanes& lanes, isa::Field bits, Vector value, Vector mask, Place at) {
  std::uint64_t* const words = lanes.memory + bits.base / lane_bits * lanes.stride;
  const std::uint32_t shift = bits.base % lane_bits;
  const Vector required = hn::And(mask, set(ones(bits.width)));
  blend(words, left(value, shift), left(required, shift), at);
  if (shift + bits.width > lane_bits)
    blend(words + lanes.stride, right(value, lane_bits - shift), right(required, lane_bits - shift), at);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::scan_line::kernels
HWY_AFTER_NAMESPACE();

#endif
