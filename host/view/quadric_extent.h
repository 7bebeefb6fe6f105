#pragma once

#include <glm/vec3.hpp>

#include "host/facet/quadric_table.h"
#include "host/view/projection.h"

namespace csgsim::view {

/// How much a solid that this side of a quadric bounds has to grow about a point within it, as a part of its size in
/// columns, rows and depth steps, to hold the rounded quadric over its pixels. Infinite where no bound is known.
double growth_of(const ScreenQuadric& quadric, facet::QuadricSide side, const glm::dvec3& inside, const View& view,
                 const PixelRect& pixels);

/// Narrows an extent to what the quadric's integers leave of its pixels and depths.
void narrow(Extent& extent, const ScreenQuadric& quadric, facet::QuadricSide side, const View& view);

}  // namespace csgsim::view
