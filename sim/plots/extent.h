#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::plots {

/// The values that an axis goes from and to, and where each of them is along it.
struct Extent {
  double low = 0;  ///< the least positive value where the scale is logarithmic
  double high = 1;
  bool is_logarithmic = false;
  bool has_zero = false;  ///< logarithmic, with a place for 0 before low

  /// 0 at the axis's beginning, 1 at its end.
  [[nodiscard]] double along(double value) const;

  /// At most so many, and one more for 0 on a logarithmic axis; at whole numbers alone, if that is asked for.
  [[nodiscard]] std::vector<Tick> ticks(unsigned most, bool is_whole = false) const;
};

/// Where a linear axis of values of 0 or more begins.
enum class Begin : std::uint8_t {
  at_values,  ///< a little below the least
  near_zero,  ///< at 0, where values come near it; else a little below the least
  at_zero,
};

/// Room for all finite values, with a margin.
Extent extent_of(std::span<const double> values, Scale scale, Begin begin);

}  // namespace csgsim::plots
