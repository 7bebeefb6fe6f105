#include "host/emit/fast_spheres.h"

#include <algorithm>
#include <array>
#include <bit>

#include "host/emit/fields.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;

/// The negated minimum of t (t - (side - 1)) over integers t.
std::int64_t valley_depth(std::int64_t side) { return (side - 1) * (side - 1) / 4; }

/// The pixels of a region along one axis.
struct Axis {
  bool is_x;
  std::int64_t first;
  std::int64_t side;

  [[nodiscard]] view::FixedLinear line(std::int64_t constant) const { return {is_x ? 1 : 0, is_x ? 0 : 1, constant}; }
};

std::array<Axis, 2> region_axes(const isa::Region& region) {
  return {Axis{true, region.x, region.width}, Axis{false, region.y, region.height}};
}

/// x^2 + y^2 in picture coordinates minus the squares in memory. The difference is linear.
view::FixedLinear linear_rest(const isa::Region& region) {
  view::FixedLinear left;
  for (const Axis& axis : region_axes(region)) {
    (axis.is_x ? left.a : left.b) = 2 * axis.first + axis.side - 1;
    left.c -= axis.first * axis.first + (axis.side - 1) * axis.first + valley_depth(axis.side);
  }
  return left;
}

view::FixedLinear sum(const view::FixedLinear& one, const view::FixedLinear& other, std::int64_t times) {
  return {one.a + times * other.a, one.b + times * other.b, one.c + times * other.c};
}

/// The linear function r^2 - d^2 plus the squares in memory, with the discriminant's fraction bits.
view::FixedLinear above_squares(const Context& context, const view::ScreenQuadric& sphere) {
  return sum(sphere.discriminant.linear, linear_rest(context.plan.region),
             -(std::int64_t{1} << sphere.discriminant_shift));
}

void add_squares(Broadcast& out, const Axis& axis, isa::Field squares, const view::PixelRect& pixels) {
  const auto bits = static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(axis.side - 1)));
  for (unsigned bit = 0; bit < bits; ++bit) {
    out.plain(Opcode::enable_all);
    out.stripe(axis.line(-axis.first), bit + 1);
    out.expression(Opcode::linear_plus, subfield(squares, bit, squares.width - bit),
                   axis.line(1 - axis.first - axis.side), 0, pixels);
  }
}

}  // namespace

unsigned squares_bits(const isa::Region& region) {
  const std::int64_t most = valley_depth(region.width) + valley_depth(region.height);
  return std::max(1U, static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(most))));
}

void emit_squares(const Context& context, Broadcast& out) {
  const isa::Region& region = context.plan.region;
  const isa::Field squares = context.layout.squares;
  out.origin = {isa::Purpose::setup, isa::no_primitive, isa::no_node};
  out.plain(Opcode::enable_all);
  out.constant(squares, static_cast<std::uint64_t>(valley_depth(region.width) + valley_depth(region.height)));
  for (const Axis& axis : region_axes(region)) add_squares(out, axis, squares, context.plan.pixels());
}

void emit_circle(const Context& context, Broadcast& out, const view::ScreenQuadric& sphere,
                 const view::PixelRect& pixels) {
  out.expression(Opcode::linear_ge, context.layout.squares, above_squares(context, sphere), sphere.discriminant_shift,
                 pixels);
}

void emit_paraboloid(const Context& context, Broadcast& out, const view::ScreenQuadric& sphere, bool is_near,
                     isa::Field sum_field, const view::PixelRect& pixels) {
  const view::TwoPowers& factor = sphere.factor;
  const unsigned fraction = factor.fraction();
  const std::int64_t middle = (sphere.middle.c >> context.view.sampling.fraction_bits) + (is_near ? 0 : 1);
  const auto scaled_middle = static_cast<std::int64_t>(static_cast<std::uint64_t>(middle) << fraction);
  if (factor.is_zero) {
    out.constant(sum_field, static_cast<std::uint64_t>(scaled_middle));
    return;
  }
  const std::int64_t times = is_near ? -factor.scaled() : factor.scaled();
  const view::FixedLinear linear = sum({0, 0, scaled_middle * (std::int64_t{1} << sphere.discriminant_shift)},
                                       above_squares(context, sphere), times);
  const auto up = [&](int exponent) { return static_cast<unsigned>(exponent + static_cast<int>(fraction)); };
  const auto add = [&](unsigned places) {
    if (places >= sum_field.width) return;
    const isa::Field target = subfield(sum_field, places, sum_field.width - places);
    const isa::Field squares = context.layout.squares;
    out.plain(Opcode::add, target, subfield(squares, 0, std::min(squares.width, target.width)));
  };
  // near = linear + greater -/+ smaller, far = linear - greater +/- smaller: subtracted terms are written first.
  const bool greater_is_taken = !is_near;
  const bool smaller_is_taken = factor.signs < 0 ? is_near : !is_near;
  if (factor.signs == 0 || greater_is_taken == smaller_is_taken) {
    out.shifted(context.layout.squares, sum_field, up(factor.first));
    if (factor.signs != 0) add(up(factor.second));
    out.expression(greater_is_taken ? Opcode::linear_minus : Opcode::linear_plus, sum_field, linear,
                   sphere.discriminant_shift, pixels);
    return;
  }
  out.shifted(context.layout.squares, sum_field, up(greater_is_taken ? factor.first : factor.second));
  out.expression(Opcode::linear_minus, sum_field, linear, sphere.discriminant_shift, pixels);
  add(up(greater_is_taken ? factor.second : factor.first));
}

}  // namespace csgsim::emit
