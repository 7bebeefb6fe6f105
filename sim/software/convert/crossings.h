#pragma once

#include <cstddef>
#include <span>

#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

/// Ends sides where sides of one of these outlines cross, as they are seen from outside of its plane, and at its points
/// that they pass through. A side that several outlines share ends in all of them. Whether there was any.
bool end_at_crossings(std::span<const std::size_t> which, Outlines& outlines);

}  // namespace csgsim::software::convert
