#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/effects/shadow_receivers.h"
#include "host/effects/shadow_volumes.h"

namespace csgsim::effects {

/// What is sure of a receiver's outline and a half-space, whatever rounding does.
enum class ReceiverSide : std::int8_t {
  beyond = -1,  ///< nothing of it is in the half-space
  open = 0,     ///< not known
  within = 1,   ///< nothing of it is out of the half-space
};

/// Holds planes of shadow volumes against the boxes of many receivers' outlines, in vectors.
class ReceiverSides {
 public:
  /// `fraction_bits`: of surfaces.
  ReceiverSides(std::span<const Receiver> receivers, unsigned fraction_bits);

  /// Of each receiver: PlaneComparison's lines over its box.
  void decide(const ShadowPlane& plane, std::span<ReceiverSide> sides);

 private:
  using Numbers = std::vector<double>;

  // By receiver: the least and greatest columns and rows of its outline, its plane, and the most that a column, a row
  // and the terms of its plane's values come to.
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
  Numbers sums_;  ///< room for decide()
  double last_;   ///< the greatest fraction of a depth step
};

}  // namespace csgsim::effects
