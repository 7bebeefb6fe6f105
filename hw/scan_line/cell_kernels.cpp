#include "hw/scan_line/cell_kernels.h"

#include "hw/isa/opcodes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hw/scan_line/cell_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <algorithm>

#include "hw/scan_line/cell_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::scan_line::kernels {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Bit numbers of the ALU's condition flags.
constexpr int carry_flag = 0;  // carry out of the processed bits, or borrow of a difference
constexpr int differs_flag = 1;
constexpr int beyond_flag = 2;    // some bit of x above the target field's width is 1
constexpr int negative_flag = 3;  // highest bit of the value
constexpr int x_flag = 4;         // first of the flags with the highest bits of the operands
constexpr int y_flag = 5;
// Flags of a root: the carry as above, and whether the remainder is negative.
constexpr int remainder_flag = 1;

void fetch(const FieldPart& part, std::uint64_t* fetched, const Lanes& lanes, CellRange range) {
  each(range, [&](Place at) HWY_ATTR {
    const Vector bits = bits_at(lanes, part.bits, at);
    store(part.from == 0 ? bits : hn::Or(load(fetched, at), left(bits, part.from)), fetched, at);
  });
}

/// The partial root occupies the field's upper bits, which the remainder no longer needs. A trial of bit k of the root
/// uses k + 3 bits of the field.
void try_root(const Packet& packet, const CellStep& step, const Lanes& lanes, CellRange range) {
  const std::uint32_t bits = packet.accesses.target.field.width / 2U;
  const std::uint32_t length = step.root_bit + 3;
  const std::uint32_t lowest = 2 * (bits - 1 - step.root_bit);
  const std::uint32_t place = lowest + step.trial.from;
  const Vector mask = set(ones(step.trial.count));
  const bool is_last = step.trial.from + step.trial.count == length;
  const Vector sign = set(std::uint64_t{1} << (lowest + length - 1));
  each(range, [&](Place at) HWY_ATTR {
    Vector value = load(lanes.fetched[0], at);
    Vector flags = load(lanes.flags, at);
    if (step.begins_root) {
      value = hn::And(value, set(ones(2 * bits)));
      flags = hn::Zero(Tag());
    }
    Vector negative = bit<remainder_flag>(flags);
    const Vector found = hn::ShiftLeft<2>(hn::ShiftRight<1>(right(value, 2 * bits - step.root_bit)));
    const Vector operand = select(spread(negative), hn::Add(found, set(3)), hn::Not(hn::Add(found, set(1))));
    const Vector carry = step.trial.from == 0 ? hn::Xor(negative, set(1)) : bit<carry_flag>(flags);
    const Vector sum =
        hn::Add(hn::And(right(value, place), mask), hn::Add(hn::And(right(operand, step.trial.from), mask), carry));
    value = select(left(mask, place), left(hn::And(sum, mask), place), value);
    if (is_last) {
      negative = any(hn::And(value, sign));
      value = hn::Xor(value, sign);
    }
    store(value, lanes.fetched[0], at);
    store(hn::Or(bit<0>(right(sum, step.trial.count)), hn::ShiftLeft<remainder_flag>(negative)), lanes.flags, at);
  });
}

HWY_INLINE Vector result_of(AluFunction function, Vector x, Vector y, Vector carry, Vector mask) {
  switch (function) {
    case AluFunction::none: break;
    case AluFunction::add: return hn::Add(hn::Add(x, y), carry);
    case AluFunction::subtract: return hn::Sub(hn::Sub(x, y), carry);
    case AluFunction::bit_and: return hn::And(x, y);
    case AluFunction::bit_or: return hn::Or(x, y);
    case AluFunction::bit_xor: return hn::Xor(x, y);
    case AluFunction::bit_and_not: return hn::AndNot(y, x);
    case AluFunction::bit_not: return hn::Xor(x, mask);
  }
  return hn::Zero(Tag());
}

void run_alu(const Packet& packet, AluBits bits, const Lanes& lanes, CellRange range) {
  Operands operands(packet, lanes, range);
  const bool begins = bits.from == 0;
  const std::uint32_t field_bits = packet.brings_f() ? packet.instruction.fields[0].width : 0U;
  const std::uint32_t inside = std::clamp(field_bits, bits.from, bits.from + bits.count) - bits.from;
  const Vector mask = set(ones(bits.count));
  const Vector outside = set(~ones(inside));
  const Vector kept = set(1U << differs_flag | 1U << beyond_flag);
  const auto top = [&](Vector number) HWY_ATTR { return bit<0>(right(number, bits.count - 1)); };
  each(range, [&](Place at) HWY_ATTR {
    const Vector x = hn::And(right(operands.x(at), bits.from), mask);
    const Vector y = hn::And(right(operands.y(at), bits.from), mask);
    const Vector flags = begins ? hn::Zero(Tag()) : load(lanes.flags, at);
    const Vector sum = result_of(packet.work.function, x, y, bit<carry_flag>(flags), mask);
    const Vector value = hn::And(sum, mask);
    const Vector found =
        hn::Or(hn::ShiftLeft<differs_flag>(any(value)), hn::ShiftLeft<beyond_flag>(any(hn::And(x, outside))));
    const Vector signs = hn::Or(hn::ShiftLeft<negative_flag>(top(sum)),
                                hn::Or(hn::ShiftLeft<x_flag>(top(x)), hn::ShiftLeft<y_flag>(top(y))));
    const Vector carry = bit<0>(right(sum, bits.count));
    store(hn::Or(hn::Or(hn::And(flags, kept), found), hn::Or(signs, carry)), lanes.flags, at);
    store(begins ? value : hn::Or(load(lanes.value, at), left(value, bits.from)), lanes.value, at);
  });
}

/// Signs of x - y (F minus the field) for which a comparison holds.
struct Condition {
  bool where_less = false;
  bool where_equal = false;
  bool where_greater = false;
  bool with_signs = true;  ///< whether x and y are signed
};

struct Comparison {
  isa::Opcode opcode;
  Condition holds;
};

constexpr auto comparisons = std::to_array<Comparison>({
    {isa::Opcode::linear_ge, {false, true, true}},
    {isa::Opcode::linear_gt, {false, false, true}},
    {isa::Opcode::keep_max, {false, false, true}},
    {isa::Opcode::linear_le, {true, true, false}},
    {isa::Opcode::linear_lt, {true, false, false}},
    {isa::Opcode::keep_min, {true, false, false}},
    {isa::Opcode::linear_eq, {false, true, false}},
    {isa::Opcode::field_eq, {false, true, false}},
    {isa::Opcode::field_lt, {true, false, false, false}},
    {isa::Opcode::field_le, {true, true, false, false}},
    {isa::Opcode::load_linear, {true, true, true}},
});

constexpr Condition condition_of(isa::Opcode opcode) {
  for (const Comparison& row : comparisons)
    if (row.opcode == opcode) return row.holds;
  return {};
}

/// Condition flags computed by the ALU; all zero for operands without bits.
class AluFlags {
 public:
  HWY_INLINE AluFlags(const Packet& packet, const Lanes& lanes)
      : holds_(condition_of(packet.instruction.opcode)), flags_(packet.work.bits == 0 ? nullptr : lanes.flags) {}

  HWY_INLINE void load_flags(Place at) { now_ = flags_ == nullptr ? hn::Zero(Tag()) : load(flags_, at); }

  [[nodiscard]] HWY_INLINE Vector holds() const {
    const Vector equal = hn::Xor(bit<differs_flag>(now_), set(1));
    const Vector less = holds_.with_signs ? less_with_signs() : bit<carry_flag>(now_);
    const Vector greater = hn::Xor(hn::Or(equal, less), set(1));
    Vector held = hn::Zero(Tag());
    if (holds_.where_less) held = hn::Or(held, less);
    if (holds_.where_equal) held = hn::Or(held, equal);
    if (holds_.where_greater) held = hn::Or(held, greater);
    return spread(held);
  }

  /// Whether F fits the target field. F must be operand x.
  [[nodiscard]] HWY_INLINE Vector fits() const {
    return spread(hn::Xor(hn::Or(bit<x_flag>(now_), bit<beyond_flag>(now_)), set(1)));
  }

 private:
  [[nodiscard]] HWY_INLINE Vector less_with_signs() const {
    const Vector x = bit<x_flag>(now_);
    return select(spread(hn::Xor(x, bit<y_flag>(now_))), x, bit<negative_flag>(now_));
  }

  Condition holds_;
  const std::uint64_t* flags_;
  Vector now_ = hn::Zero(Tag());
};

/// Replaces the enable bits by enable(place, old value). Returns the number of cells that were enabled.
template <class Enable>
HWY_ATTR HWY_INLINE std::uint64_t change_enable(const Lanes& lanes, CellRange range, const Enable& enable) {
  Vector count = hn::Zero(Tag());
  each(range, [&](Place at) HWY_ATTR {
    const Vector before = load(lanes.enable, at);
    count = hn::Sub(count, at.inside(before));
    store(enable(at, before), lanes.enable, at);
  });
  return hn::GetLane(hn::SumOfLanes(Tag(), count));
}

std::uint64_t count_enabled(const Lanes& lanes, CellRange range) {
  Vector count = hn::Zero(Tag());
  each(range, [&](Place at) HWY_ATTR { count = hn::Sub(count, at.inside(load(lanes.enable, at))); });
  return hn::GetLane(hn::SumOfLanes(Tag(), count));
}

/// Replaces the enable bits by enable(old value, whether the field is nonzero).
template <class Enable>
HWY_ATTR HWY_INLINE std::uint64_t combine_enable(const Packet& packet, const Lanes& lanes, CellRange range,
                                                 const Enable& enable) {
  const Source source(packet, lanes, 0);
  return change_enable(lanes, range,
                       [&](Place at, Vector before) HWY_ATTR { return enable(before, spread(any(source.at(at)))); });
}

/// Keeps cells enabled only where F is negative (if `negative`), or only where it is not.
std::uint64_t keep_where_sign(const Packet& packet, bool negative, const Lanes& lanes, CellRange range) {
  Expression f(packet, range.first);
  const Vector other = negative ? hn::Zero(Tag()) : set(~std::uint64_t{0});
  return change_enable(lanes, range, [&](Place, Vector before) HWY_ATTR {
    return hn::And(before, hn::Xor(spread(bit<lane_bits - 1>(f.next())), other));
  });
}

std::uint64_t compare(const Packet& packet, const Lanes& lanes, CellRange range) {
  AluFlags found(packet, lanes);
  return change_enable(lanes, range, [&](Place at, Vector before) HWY_ATTR {
    found.load_flags(at);
    return hn::And(before, found.holds());
  });
}

/// Marks cells where the comparison holds, so that F is written there, and disables these cells if F does not fit.
std::uint64_t keep_f(const Packet& packet, const Lanes& lanes, CellRange range) {
  AluFlags found(packet, lanes);
  return change_enable(lanes, range, [&](Place at, Vector before) HWY_ATTR {
    found.load_flags(at);
    const Vector writes = hn::And(before, found.holds());
    store(writes, lanes.writes, at);
    return hn::AndNot(hn::AndNot(found.fits(), writes), before);
  });
}

std::uint64_t act(const Packet& packet, const Lanes& lanes, CellRange range) {
  switch (enable_function_of(packet.instruction.opcode)) {
    case EnableFunction::keep: return count_enabled(lanes, range);
    case EnableFunction::set:
      return change_enable(lanes, range, [](Place, Vector) HWY_ATTR { return set(~std::uint64_t{0}); });
    case EnableFunction::invert:
      return change_enable(lanes, range, [](Place, Vector before) HWY_ATTR { return hn::Not(before); });
    case EnableFunction::load:
      return combine_enable(packet, lanes, range, [](Vector, Vector field) HWY_ATTR { return field; });
    case EnableFunction::and_field:
      return combine_enable(packet, lanes, range, [](Vector e, Vector field) HWY_ATTR { return hn::And(e, field); });
    case EnableFunction::and_not_field:
      return combine_enable(packet, lanes, range, [](Vector e, Vector field) HWY_ATTR { return hn::AndNot(field, e); });
    case EnableFunction::or_field:
      return combine_enable(packet, lanes, range, [](Vector e, Vector field) HWY_ATTR { return hn::Or(e, field); });
    case EnableFunction::xor_field:
      return combine_enable(packet, lanes, range, [](Vector e, Vector field) HWY_ATTR { return hn::Xor(e, field); });
    case EnableFunction::where_not_negative: return keep_where_sign(packet, false, lanes, range);
    case EnableFunction::where_negative: return keep_where_sign(packet, true, lanes, range);
    case EnableFunction::where_holds: return compare(packet, lanes, range);
    case EnableFunction::where_fits: return keep_f(packet, lanes, range);
  }
  return count_enabled(lanes, range);
}

/// Writes the bits of value(place) that belong to the part, where mask(place) is all ones.
template <class Value>
HWY_ATTR HWY_INLINE void write_part(const FieldPart& part, const Lanes& lanes, CellRange range,
                                    const std::uint64_t* mask, const Value& value) {
  each(range, [&](Place at) HWY_ATTR {
    const Vector where = mask == nullptr ? set(~std::uint64_t{0}) : load(mask, at);
    put_bits(lanes, part.bits, right(value(at), part.from), where, at);
  });
}

void write(const Packet& packet, const FieldPart& part, const Lanes& lanes, CellRange range) {
  using isa::Opcode;
  const Opcode opcode = packet.instruction.opcode;
  if (opcode == Opcode::enable_store) {
    write_part(part, lanes, range, nullptr, [&](Place at) HWY_ATTR { return bit<0>(load(lanes.enable, at)); });
  } else if (opcode == Opcode::load_linear || opcode == Opcode::keep_max || opcode == Opcode::keep_min) {
    Expression f(packet, range.first);
    write_part(part, lanes, range, lanes.writes, [&](Place) HWY_ATTR { return f.next(); });
  } else if (opcode == Opcode::set_constant) {
    const Vector constant = set(packet.instruction.constant);
    write_part(part, lanes, range, lanes.enable, [&](Place) HWY_ATTR { return constant; });
  } else if (opcode == Opcode::copy || opcode == Opcode::root) {
    const Source source(packet, lanes, 0);
    write_part(part, lanes, range, lanes.enable, [&](Place at) HWY_ATTR { return source.at(at); });
  } else {
    const bool has_bits = packet.work.bits > 0;
    write_part(part, lanes, range, lanes.enable,
               [&](Place at) HWY_ATTR { return has_bits ? load(lanes.value, at) : hn::Zero(Tag()); });
  }
}

std::uint64_t Execute(const Packet& packet, std::span<const CellStep> steps, const Lanes& lanes, CellRange range) {
  std::uint64_t enabled = 0;
  for (const CellStep& step : steps) {
    for (std::size_t source = 0; source < step.reads.size(); ++source)
      if (step.reads[source].bits.width > 0) fetch(step.reads[source], lanes.fetched[source], lanes, range);
    if (step.trial.count > 0) try_root(packet, step, lanes, range);
    if (step.alu.count > 0) run_alu(packet, step.alu, lanes, range);
    if (step.acts) enabled += act(packet, lanes, range);
    if (step.writes.bits.width > 0) write(packet, step.writes, lanes, range);
  }
  return enabled;
}

bool AnyOnes(std::span<const std::uint64_t> lanes) {
  Vector all = hn::Zero(Tag());
  each({0, static_cast<std::uint32_t>(lanes.size())},
       [&](Place at) HWY_ATTR { all = hn::Or(all, at.inside(load(lanes.data(), at))); });
  return !hn::AllTrue(Tag(), hn::Eq(all, hn::Zero(Tag())));
}

void AddBits(const std::uint64_t* lanes, CellRange range, std::span<std::uint64_t> words) {
  each(range, [&](Place at) HWY_ATTR {
    std::uint8_t bytes[sizeof(std::uint64_t)] = {};
    hn::StoreMaskBits(Tag(), hn::Ne(at.inside(load(lanes, at)), hn::Zero(Tag())), bytes);
    const std::uint64_t bits = bytes[0];
    const std::size_t place = at.first % lane_bits;
    words[at.first / lane_bits] |= bits << place;
    if (place + max_lanes > lane_bits && bits >> (lane_bits - place) != 0)
      words[at.first / lane_bits + 1] |= bits >> (lane_bits - place);
  });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::scan_line::kernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgsim::scan_line::kernels {

HWY_EXPORT(Execute);
HWY_EXPORT(AnyOnes);
HWY_EXPORT(AddBits);

std::uint64_t execute(const Packet& packet, std::span<const CellStep> steps, const Lanes& lanes, CellRange range) {
  return HWY_DYNAMIC_DISPATCH(Execute)(packet, steps, lanes, range);
}

void add_bits(const std::uint64_t* lanes, CellRange range, std::span<std::uint64_t> words) {
  HWY_DYNAMIC_DISPATCH(AddBits)(lanes, range, words);
}

bool any_ones(std::span<const std::uint64_t> lanes) { return HWY_DYNAMIC_DISPATCH(AnyOnes)(lanes); }

}  // namespace csgsim::scan_line::kernels
#endif
