#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

/// The same of a side and of one that runs back.
inline std::uint64_t key_of(const Side& side) {
  return static_cast<std::uint64_t>(std::min(side[0], side[1])) << 32U | std::max(side[0], side[1]);
}

/// Takes out pairs of sides that run one against the other, and those that end where they begin. What is left is
/// sorted.
void cancel(std::vector<Side>& sides);

/// Appends what a side becomes that ends at each of the points, which are in the order from its end of the lower number
/// to that of the higher.
void end_at(const Side& side, std::span<const std::uint32_t> points, std::vector<Side>& sides);

/// Ends sides at each point that is within the tolerance of them. Whether there was any.
bool end_at_points(Outlines& outlines, double tolerance);

/// Joins sides at points where only two others are joined to, on one line with it.
void join_straight(Outlines& outlines, double tolerance);

/// A side that does not run as often one way as the other, over all outlines.
std::optional<Side> open_side(const Outlines& outlines);

}  // namespace csgsim::software::convert
