// The range of values of an axis.
// Used by the layouts of charts and bars.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::plots {

/// The range of values of an axis, and the mapping from values to positions.
struct Extent {
  double low = 0;  ///< smallest positive value if the scale is logarithmic
  double high = 1;
  bool is_logarithmic = false;
  bool has_zero = false;  ///< a logarithmic axis with a separate place for 0 before `low`

  /// Position of a value: 0 at the start of the axis, 1 at its end.
  [[nodiscard]] double fraction_along(double value) const;

  /// Up to `max_count` ticks, plus one for 0 on a logarithmic axis; only whole numbers if `is_whole`.
  [[nodiscard]] std::vector<Tick> ticks(unsigned max_count, bool is_whole = false) const;
};

/// Start of a linear axis whose values are all non-negative.
enum class Begin : std::uint8_t {
  at_values,  ///< a little below the minimum
  near_zero,  ///< at 0 if the values come near it, otherwise a little below the minimum
  at_zero,
};

/// Range that holds all finite values, with a margin.
Extent make_extent(std::span<const double> values, Scale scale, Begin begin);

}  // namespace csgsim::plots
