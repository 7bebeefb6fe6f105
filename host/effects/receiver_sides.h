// Vectorized tests of receivers against planes of shadow volumes.
// Used by shadow_parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/effects/shadow_receivers.h"
#include "host/effects/shadow_volumes.h"

namespace csgsim::effects {

/// Position of a receiver's outline relative to a half-space that is certain in spite of rounding.
enum class ReceiverSide : std::int8_t {
  beyond = -1,  ///< entirely outside the half-space
  open = 0,     ///< possibly on both sides
  within = 1,   ///< entirely inside the half-space
};

/// Compares planes of shadow volumes with the bounding boxes of many receivers' outlines, vectorized.
class ReceiverSides {
 public:
  /// `fraction_bits`: fraction bits of surfaces.
  ReceiverSides(std::span<const Receiver> receivers, unsigned fraction_bits);

  /// Sets `sides[i]` to the position of the box of receiver i's outline relative to the plane.
  void decide(const ShadowPlane& plane, std::span<ReceiverSide> sides);

 private:
  using Numbers = std::vector<double>;

  // One element per receiver: bounds of the columns and rows of its outline, its plane, and upper bounds of the
  // magnitudes of a column, a row and the terms of its plane's values.
  Numbers x0_;
  Numbers x1_;
  Numbers y0_;
  Numbers y1_;
  Numbers a_;
  Numbers b_;
  Numbers c_;
  Numbers reach_x_;
  Numbers reach_y_;
  Numbers terms_;
  Numbers sums_;  ///< scratch of decide()
  double last_;   ///< greatest fraction of a depth step
};

}  // namespace csgsim::effects
