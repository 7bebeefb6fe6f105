// Intersections of sides of outlines.
// Used by outlines.cpp.
#pragma once

#include <cstddef>
#include <span>

#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

/// Splits the sides of these outlines at their intersections with sides of the same outline, as seen from outside of
/// its plane, and at points of the outline that they pass through. A side shared by several outlines is split in all of
/// them. Returns whether any side was split.
bool try_split_at_crossings(std::span<const std::size_t> outline_indices, Outlines& outlines);

}  // namespace csgsim::software::convert
