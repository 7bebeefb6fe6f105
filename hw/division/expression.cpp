#include "hw/division/expression.h"

#include <algorithm>
#include <bit>

namespace csgsim::division {

namespace {

/// Number of low zero bits that A and B share.
unsigned shared_zeros(const Plane& plane) {
  return static_cast<unsigned>(
      std::countr_zero(static_cast<std::uint64_t>(plane.a) | static_cast<std::uint64_t>(plane.b)));
}

Plane without(const Plane& plane, unsigned bits) {
  return {plane.is_edge, plane.a >> bits, plane.b >> bits, plane.c >> bits};
}

}  // namespace

Expression depth_expression(const ModelHeader& header, const Plane& plane) {
  const unsigned dropped = std::min(shared_zeros(plane), header.fraction_bits);
  return {without(plane, dropped), header.fraction_bits - dropped};
}

Expression line_expression(const Plane& plane) {
  return {without(plane, std::min(shared_zeros(plane), isa::max_linear_width)), 0};
}

Plane depth_range_excess(const ModelHeader& header, const Plane& plane) {
  return {true, plane.a, plane.b, plane.c - ((header.farthest() + 1) << header.fraction_bits)};
}

isa::Linear linear_of(const Expression& expression, const isa::Region& square, unsigned width_bits) {
  const Plane& plane = expression.plane;
  return {plane.a, plane.b, plane.c + plane.a * square.x + plane.b * square.y, static_cast<std::uint16_t>(width_bits),
          static_cast<std::uint16_t>(expression.shift)};
}

}  // namespace csgsim::division
