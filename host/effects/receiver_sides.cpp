#include "host/effects/receiver_sides.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace csgsim::effects {

namespace {

/// Relative error bound of a value's terms, greater than the rounding margin of Outline::clip() plus the errors here.
constexpr double doubt = 4e-11;

/// PlaneComparison::in() of a receiver's plane R and a plane P, in doubles: `receiver` R + `own` P + `more`.
struct Factors {
  double receiver;
  double own;
  double more;
};

Factors make_factors(const ShadowPlane& plane, double last) {
  switch (plane.side) {
    case view::Side::front: return {1, -1, plane.is_strict ? -1 : last};
    case view::Side::back: return {-1, 1, -1};
    case view::Side::edge_positive: return {0, 1, 0};
    case view::Side::edge_negative: return {0, -1, -1};
  }
  return {0, 1, 0};
}

}  // namespace

ReceiverSides::ReceiverSides(std::span<const Receiver> receivers, unsigned fraction_bits)
    : last_(std::ldexp(1.0, static_cast<int>(fraction_bits)) - 1.0) {
  for (const Receiver& one : receivers) {
    glm::dvec2 low(0);
    glm::dvec2 high(0);
    if (!one.outline.empty()) low = high = one.outline.corners().front();
    for (const glm::dvec2& corner : one.outline.corners()) {
      low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
      high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    x0_.push_back(low.x);
    x1_.push_back(high.x);
    y0_.push_back(low.y);
    y1_.push_back(high.y);
    a_.push_back(static_cast<double>(one.plane.a));
    b_.push_back(static_cast<double>(one.plane.b));
    c_.push_back(static_cast<double>(one.plane.c));
    reach_x_.push_back(1.0 + std::max(std::abs(low.x), std::abs(high.x)));
    reach_y_.push_back(1.0 + std::max(std::abs(low.y), std::abs(high.y)));
    terms_.push_back(std::abs(a_.back()) * reach_x_.back() + std::abs(b_.back()) * reach_y_.back() +
                     std::abs(c_.back()));
  }
}

void ReceiverSides::decide(const ShadowPlane& plane, std::span<ReceiverSide> sides) {
  const auto [receiver, own, more] = make_factors(plane, last_);
  const double own_a = own * static_cast<double>(plane.linear.a);
  const double own_b = own * static_cast<double>(plane.linear.b);
  const double own_c = own * static_cast<double>(plane.linear.c) + more;
  const double size_a = std::abs(own_a);
  const double size_b = std::abs(own_b);
  const double size_c = std::abs(own_c) + last_ + 1.0;
  sums_.resize(terms_.size());
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const double a = receiver * a_[i] + own_a;
    const double b = receiver * b_[i] + own_b;
    const double c = receiver * c_[i] + own_c;
    const double low_x = a * x0_[i];
    const double high_x = a * x1_[i];
    const double low_y = b * y0_[i];
    const double high_y = b * y1_[i];
    const double most = (low_x > high_x ? low_x : high_x) + (low_y > high_y ? low_y : high_y) + c;
    const double least = (low_x < high_x ? low_x : high_x) + (low_y < high_y ? low_y : high_y) + c;
    const double near = doubt * (terms_[i] + size_a * reach_x_[i] + size_b * reach_y_[i] + size_c);
    // A point outside the half-space may also be inside if it is outside by less than a depth step.
    sums_[i] = (least > last_ + near ? 1.0 : 0.0) - (most < -near ? 1.0 : 0.0);
  }
  for (std::size_t i = 0; i < sums_.size(); ++i) sides[i] = static_cast<ReceiverSide>(static_cast<int>(sums_[i]));
}

}  // namespace csgsim::effects
