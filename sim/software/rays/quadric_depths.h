#pragma once

#include <cstdint>

#include "host/facet/geometry.h"
#include "host/view/projection.h"

namespace csgsim::software {

/// Depths along a ray, front <= z < back; none unless front < back.
struct Depths {
  std::int64_t front = 0;
  std::int64_t back = 0;
};

/// What is left of them within a quadric, at a pixel.
Depths within(Depths depths, const view::View& view, facet::QuadricSide side, std::int32_t x, std::int32_t y);

}  // namespace csgsim::software
