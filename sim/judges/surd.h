// Exact numbers with one square root.
// Used by the sights of the judges.
#pragma once

#include "sim/judges/dyadic.h"

namespace csgsim::judges {

/// The exact number (whole + root sqrt(square)) / over.
struct Surd {
  Dyadic whole;
  int root = 0;     ///< -1, 0 or 1
  Dyadic square{};  ///< not negative
  Dyadic over;      ///< not 0

  /// The value with an error of about 10^-100 of the larger of its two terms.
  [[nodiscard]] Real to_real() const;
};

/// Exact sign of a - b, computed by squaring.
int compare(const Surd& a, const Surd& b);

}  // namespace csgsim::judges
