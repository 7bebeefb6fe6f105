// Conservative comparisons of a receiver's rounded depths with half-spaces. Used by shadow_parts and shadow_receivers.
#pragma once

#include <cstdint>

#include "host/effects/shadow_volumes.h"
#include "host/view/fixed_point.h"

namespace csgsim::effects {

/// Lines for testing points of a receiver's plane, whose depth is floor(F), against a half-space: in() is not negative
/// where they may be inside, out() is not negative where they may be outside. Where out() is negative, all points are
/// certainly inside.
class PlaneComparison {
 public:
  PlaneComparison(const view::FixedLinear& receiver, unsigned fraction_bits)
      : receiver_(receiver), last_((std::int64_t{1} << fraction_bits) - 1) {}

  [[nodiscard]] view::FixedLinear in(const ShadowPlane& plane) const {
    switch (plane.side) {
      case view::Side::front: return view::difference(receiver_, plane.linear, plane.is_strict ? -1 : last_);
      case view::Side::back: return view::difference(plane.linear, receiver_, -1);
      case view::Side::edge_positive: return plane.linear;
      case view::Side::edge_negative: return view::difference({}, plane.linear, -1);
    }
    return plane.linear;
  }

  [[nodiscard]] view::FixedLinear out(const ShadowPlane& plane) const {
    switch (plane.side) {
      case view::Side::front: return view::difference(plane.linear, receiver_, plane.is_strict ? last_ : -1);
      case view::Side::back: return view::difference(receiver_, plane.linear, last_);
      case view::Side::edge_positive: return view::difference({}, plane.linear, -1);
      case view::Side::edge_negative: return plane.linear;
    }
    return plane.linear;
  }

  /// If in() is at least this value, out() is negative.
  [[nodiscard]] double certainly_in() const { return static_cast<double>(last_) + 1.0; }

 private:
  view::FixedLinear receiver_;
  std::int64_t last_;  ///< greatest fraction of a depth step
};

}  // namespace csgsim::effects
