#pragma once

#include "sim/judges/dyadic.h"

namespace csgsim::judges {

/// The exact number (whole + root sqrt(square)) / over.
struct Surd {
  Dyadic whole;
  int root = 0;     ///< -1, 0 or 1
  Dyadic square{};  ///< not negative
  Dyadic over;      ///< not 0

  /// To some 100 digits of the larger of its two terms.
  [[nodiscard]] Real to_real() const;
};

/// Sign of a - b, by squaring: exact.
int compare(const Surd& a, const Surd& b);

}  // namespace csgsim::judges
