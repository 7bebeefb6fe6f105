#include "hw/division/writer.h"

#include <algorithm>

#include "hw/base/error.h"
#include "hw/division/widths.h"

namespace csgsim::division {

namespace {

using isa::Opcode;

/// Bits of the plane's values over the pixels; the extremes are at corners.
unsigned width_over(const Plane& plane, const Rectangle& pixels) {
  unsigned width = 1;
  for (const std::int32_t x : {pixels.x0, pixels.x1}) {
    for (const std::int32_t y : {pixels.y0, pixels.y1}) {
      width = std::max(width, signed_width(plane.a * x + plane.b * y + plane.c));
    }
  }
  return width;
}

}  // namespace

void Writer::plain(Opcode opcode, isa::Field field, isa::Field second, std::uint64_t constant) {
  write({opcode, {field, second, {}}, {}, constant, origin});
}

void Writer::write(const isa::Instruction& instruction) {
  const isa::Field field = instruction.fields[0];
  const bool moves_enable = instruction.opcode == Opcode::enable_load || instruction.opcode == Opcode::enable_store;
  if (moves_enable && field == known_enable_) return;
  written_.push_back(instruction);
  const bool leaves_enable = instruction.opcode == Opcode::set_constant || instruction.opcode == Opcode::copy;
  if (moves_enable) {
    known_enable_ = field;
  } else if (!leaves_enable || field.overlaps(known_enable_)) {
    known_enable_ = {};
  }
}

void Writer::linear(Opcode opcode, isa::Field field, const Expression& expression, const Rectangle& pixels) {
  unsigned width = width_over(expression.plane, pixels);
  // F has one bit more than the field that it is compared with, for its sign.
  if (field.width > 0) width = std::max(width, expression.shift + field.width + 1U);
  if (width > isa::max_linear_width)
    throw InputError("the display model: a plane needs more bits than a linear expression can have");
  write({opcode, {field, {}, {}}, linear_of(expression, square_, width), 0, origin});
}

void Writer::depth(Opcode opcode, isa::Field field, const Plane& plane, const Rectangle& pixels) {
  linear(opcode, field, depth_expression(header_, plane), pixels);
}

void Writer::line(Opcode opcode, const Plane& line, const Rectangle& pixels) {
  linear(opcode, {}, line_expression(line), pixels);
}

void Writer::clip(const Rectangle& inner, const Rectangle& outer) {
  Rectangle left = outer;
  if (inner.x0 > outer.x0) {
    line(Opcode::edge_not_negative, {true, 1, 0, -inner.x0}, left);
    left.x0 = inner.x0;
  }
  if (inner.x1 < outer.x1) {
    line(Opcode::edge_not_negative, {true, -1, 0, inner.x1}, left);
    left.x1 = inner.x1;
  }
  if (inner.y0 > outer.y0) {
    line(Opcode::edge_not_negative, {true, 0, 1, -inner.y0}, left);
    left.y0 = inner.y0;
  }
  if (inner.y1 < outer.y1) line(Opcode::edge_not_negative, {true, 0, -1, inner.y1}, left);
}

void Writer::edges(const std::vector<TestedHalfspace>& tested, const Rectangle& pixels) {
  for (const TestedHalfspace& one : tested) {
    const bool not_negative = one.side == Side::not_negative;
    if (!not_negative && one.side != Side::negative) continue;
    if (classify_between(one, 0, 0) == Containment::in) continue;
    line(not_negative ? Opcode::edge_not_negative : Opcode::edge_negative, one.plane, pixels);
  }
}

}  // namespace csgsim::division
