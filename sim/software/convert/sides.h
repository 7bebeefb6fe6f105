#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

/// Takes out pairs of sides that run one against the other, and those that end where they begin. What is left is
/// sorted.
void cancel(std::vector<Side>& sides);

/// Ends sides at each point that is within the tolerance of them. Whether there was any.
bool end_at_points(Outlines& outlines, double tolerance);

/// Joins sides at points where only two others are joined to, on one line with it.
void join_straight(Outlines& outlines, double tolerance);

/// A side that does not run as often one way as the other, over all outlines.
std::optional<Side> open_side(const Outlines& outlines);

}  // namespace csgsim::software::convert
