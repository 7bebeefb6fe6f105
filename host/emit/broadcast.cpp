#include "host/emit/broadcast.h"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

#include "host/emit/fields.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

/// Work charged for each appended instruction, in steps.
constexpr std::uint64_t instruction_steps = 40;

/// Number of low zero bits common to A and B, at most `limit`. Dropping that many low bits of A, B and C (C rounded
/// down) changes neither the floor of the sum nor its sign.
unsigned shared_zeros(const view::FixedLinear& plane, unsigned limit) {
  const std::uint64_t both = static_cast<std::uint64_t>(plane.a) | static_cast<std::uint64_t>(plane.b);
  return std::min(limit, static_cast<unsigned>(std::countr_zero(both)));
}

unsigned shared_zeros(const view::FixedQuadratic& quadratic, unsigned limit) {
  const auto all = static_cast<std::uint64_t>(quadratic.xx | quadratic.xy | quadratic.yy);
  return std::min(shared_zeros(quadratic.linear, limit), static_cast<unsigned>(std::countr_zero(all)));
}

view::FixedQuadratic without_low_bits(const view::FixedQuadratic& q, unsigned bits) {
  return {q.xx >> bits, q.xy >> bits, q.yy >> bits, {q.linear.a >> bits, q.linear.b >> bits, q.linear.c >> bits}};
}

/// The same function with (x, y) as the origin of columns and rows.
view::FixedQuadratic moved(const view::FixedQuadratic& q, std::int64_t x, std::int64_t y) {
  const view::FixedLinear& linear = q.linear;
  return {q.xx,
          q.xy,
          q.yy,
          {linear.a + 2 * q.xx * x + q.xy * y, linear.b + q.xy * x + 2 * q.yy * y,
           linear.c + (linear.a + q.xx * x + q.xy * y) * x + (linear.b + q.yy * y) * y}};
}

/// Whether the instruction always preserves E. Code before a skip does not dominate the code after it, so a skip counts
/// as changing E.
bool keeps_enable(isa::Opcode opcode) {
  return isa::info(opcode).enable_effect == isa::EnableEffect::keeps && opcode != isa::Opcode::skip_if_none;
}

/// The bit known to equal E after the instruction, given the bit known to equal E before it; width 0 if none is known.
isa::Field equal_after(const isa::Instruction& instruction, isa::Field equal) {
  const isa::Field first = instruction.fields[0];
  if (instruction.opcode == isa::Opcode::enable_load || instruction.opcode == isa::Opcode::enable_store) return first;
  const bool writes = isa::info(instruction.opcode).operands[0] == isa::OperandKind::target;
  return keeps_enable(instruction.opcode) && !(writes && first.overlaps(equal)) ? equal : isa::Field{};
}

}  // namespace

unsigned signed_width(const view::Range& range) {
  const auto width = [](std::int64_t value) {
    return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(value < 0 ? ~value : value))) + 1;
  };
  return std::max(width(range.low), width(range.high));
}

Broadcast::Broadcast(isa::Segment& segment, const view::Sampling& sampling, Work work)
    : segment_(segment), fraction_bits_(sampling.fraction_bits), work_(std::move(work)) {}

void Broadcast::plain(isa::Opcode opcode, isa::Field first, isa::Field second, std::uint64_t constant) {
  append({opcode, {first, second, {}}, {}, constant, origin});
}

void Broadcast::append_bitwise(isa::Opcode opcode, isa::Field target, isa::Field left, isa::Field right) {
  append({opcode, {target, left, right}, {}, 0, origin});
}

void Broadcast::constant(isa::Field field, std::uint64_t value) {
  for (unsigned first = 0; first < field.width; first += isa::max_field_width) {
    const unsigned width = std::min<unsigned>(field.width - first, isa::max_field_width);
    plain(isa::Opcode::set_constant, subfield(field, first, width), {},
          value >> first & ((std::uint64_t{1} << width) - 1));
  }
}

void Broadcast::shifted(isa::Field source, isa::Field target, unsigned left_shift) {
  const unsigned low = std::min<unsigned>(left_shift, target.width);
  const unsigned width = std::min<unsigned>(source.width, target.width - low);
  constant(subfield(target, 0, low), 0);
  const isa::Field to = subfield(target, low, width);
  const isa::Field from = subfield(source, 0, width);
  if (width > 0 && to != from) plain(isa::Opcode::copy, to, from);
  constant(subfield(target, low + width, target.width - low - width), 0);
}

void Broadcast::disable_all() { append({isa::Opcode::edge_negative, {}, {0, 0, 0, 1, 0}, 0, origin}); }

void Broadcast::append(const isa::Instruction& instruction) {
  const bool meets_equal =
      (instruction.opcode == isa::Opcode::enable_load || instruction.opcode == isa::Opcode::enable_store) &&
      instruction.fields[0] == equal_;
  if (meets_equal) return;
  work_.charge(instruction_steps, "broadcasting the model");
  segment_.instructions.push_back(instruction);
  segment_.instructions.back().origin.effect = effect;
  equal_ = equal_after(instruction, equal_);
}

void Broadcast::insert(std::size_t index, const isa::Instruction& instruction) {
  // A skip may end here, so nothing is known about E at this point.
  equal_ = {};
  const auto inserted =
      segment_.instructions.insert(segment_.instructions.begin() + static_cast<std::ptrdiff_t>(index), instruction);
  inserted->origin.effect = effect;
}

void Broadcast::linear(isa::Opcode opcode, isa::Field field, view::FixedLinear plane, unsigned shift,
                       const view::PixelRect& pixels) {
  const unsigned needed =
      std::max(signed_width(view::range_over(plane, pixels)), field.width > 0 ? shift + field.width + 1 : 1);
  if (needed > isa::max_linear_width) throw std::logic_error("a linear expression is wider than the evaluator");
  const std::int64_t corner = plane.c + plane.a * segment_.region.x + plane.b * segment_.region.y;
  const isa::Linear expression{plane.a, plane.b, corner, static_cast<std::uint16_t>(needed),
                               static_cast<std::uint16_t>(shift)};
  append({opcode, {field, {}, {}}, expression, 0, origin});
}

void Broadcast::surface(isa::Opcode opcode, isa::Field field, const view::FixedLinear& plane,
                        const view::PixelRect& pixels) {
  expression(opcode, field, plane, fraction_bits_, pixels);
}

void Broadcast::expression(isa::Opcode opcode, isa::Field field, const view::FixedLinear& line, unsigned shift,
                           const view::PixelRect& pixels) {
  counted.test_if_new(line, pixels);
  const unsigned drop = shared_zeros(line, shift);
  linear(opcode, field, {line.a >> drop, line.b >> drop, line.c >> drop}, shift - drop, pixels);
}

void Broadcast::edge(isa::Opcode opcode, const view::FixedLinear& line, const view::PixelRect& pixels) {
  counted.test_if_new(line, pixels);
  cut(opcode, line, pixels);
}

void Broadcast::cut(isa::Opcode opcode, const view::FixedLinear& line, const view::PixelRect& pixels) {
  const unsigned drop = shared_zeros(line, isa::max_linear_width);
  linear(opcode, {}, {line.a >> drop, line.b >> drop, line.c >> drop}, 0, pixels);
}

void Broadcast::quadratic(isa::Opcode opcode, isa::Field field, const view::FixedQuadratic& quadratic, unsigned shift,
                          const view::PixelRect& pixels) {
  counted.test_if_new(quadratic.linear, pixels);
  const unsigned drop = shared_zeros(quadratic, shift);
  const view::FixedQuadratic q = without_low_bits(quadratic, drop);
  const unsigned fraction = shift - drop;
  const unsigned needed =
      std::max(signed_width(view::range_over(q, pixels)), field.width > 0 ? fraction + field.width + 1 : 1);
  if (needed > isa::max_linear_width) throw std::logic_error("a quadratic expression is wider than the evaluator");
  const auto width = static_cast<std::uint16_t>(needed);
  const view::FixedQuadratic local = moved(q, segment_.region.x, segment_.region.y);
  append({isa::Opcode::squares, {}, {local.xx, local.xy, local.yy, width, 0}, 0, origin});
  append({opcode,
          {field, {}, {}},
          {local.linear.a, local.linear.b, local.linear.c, width, static_cast<std::uint16_t>(fraction)},
          0,
          origin});
}

void Broadcast::stripe(const view::FixedLinear& line, unsigned width) {
  if (width > isa::max_linear_width) throw std::logic_error("a stripe is wider than the evaluator");
  const std::int64_t corner = line.c + line.a * segment_.region.x + line.b * segment_.region.y;
  // Only the low bits matter; the others would make the sum wider than necessary.
  const std::int64_t period = std::int64_t{1} << width;
  append({isa::Opcode::stripe, {}, {line.a, line.b, corner % period, static_cast<std::uint16_t>(width), 0}, 0, origin});
}

void Broadcast::equals(isa::Field field, std::uint32_t number) {
  append({isa::Opcode::linear_eq,
          {field, {}, {}},
          {0, 0, number, static_cast<std::uint16_t>(field.width + 1), 0},
          0,
          origin});
}

void Broadcast::clip(const view::PixelRect& inner, const view::PixelRect& outer) {
  view::PixelRect left = outer;
  const auto side = [&](bool cuts, const view::FixedLinear& line) {
    if (!cuts) return;
    cut(isa::Opcode::edge_not_negative, line, left);
    left = view::common(left, {line.a > 0 ? inner.x0 : left.x0, line.b > 0 ? inner.y0 : left.y0,
                               line.a < 0 ? inner.x1 : left.x1, line.b < 0 ? inner.y1 : left.y1});
  };
  side(inner.x0 > outer.x0, {1, 0, -inner.x0});
  side(inner.x1 < outer.x1, {-1, 0, inner.x1});
  side(inner.y0 > outer.y0, {0, 1, -inner.y0});
  side(inner.y1 < outer.y1, {0, -1, inner.y1});
}

}  // namespace csgsim::emit
