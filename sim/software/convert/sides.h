#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sim/software/convert/near_points.h"
#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

/// Ends sides of those outlines, ascending, at each point that is within the tolerance of them. Returns the outlines
/// that it changed.
std::vector<std::size_t> end_at_points(std::span<const std::size_t> which, const NearPoints& near, double tolerance,
                                       Outlines& outlines);

/// Joins sides at points where only two others are joined to, on one line with it.
void join_straight(Outlines& outlines, double tolerance);

/// A side that does not run as often one way as the other, over all outlines.
std::optional<Side> open_side(const Outlines& outlines);

}  // namespace csgsim::software::convert
