// Spans of pixels in a row.
// Used to scan-convert primitives and facets.
#pragma once

#include <algorithm>
#include <cstdint>

#include "hw/base/quotient.h"

namespace csgsim::software {

/// Columns of a row, both ends included.
struct Span {
  std::int32_t first = 0;
  std::int32_t last = -1;

  [[nodiscard]] bool empty() const { return first > last; }
  [[nodiscard]] std::int32_t columns() const { return last - first + 1; }
};

/// Clips a span to the columns where a x + rest >= 0.
inline void clip(Span& span, std::int64_t a, std::int64_t rest) {
  if (a == 0) {
    if (rest < 0) span.last = span.first - 1;
  } else if (a > 0) {
    const std::int64_t minimum = -quotient_down(rest, a);
    span.first = static_cast<std::int32_t>(std::clamp<std::int64_t>(minimum, span.first, std::int64_t{span.last} + 1));
  } else {
    const std::int64_t maximum = quotient_down(rest, -a);
    span.last = static_cast<std::int32_t>(std::clamp<std::int64_t>(maximum, std::int64_t{span.first} - 1, span.last));
  }
}

/// Clips a span to the columns where a x + rest >= 0 if `positive`, or < 0 otherwise.
inline void clip(Span& span, std::int64_t a, std::int64_t rest, bool positive) {
  if (positive) {
    clip(span, a, rest);
  } else {
    clip(span, -a, -rest - 1);
  }
}

}  // namespace csgsim::software
