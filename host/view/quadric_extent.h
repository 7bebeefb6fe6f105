#pragma once

#include <glm/vec3.hpp>

#include "host/facet/quadrics.h"
#include "host/view/projection.h"

namespace csgsim::view {

/// By which part a solid, which that side of a quadric bounds, has to be scaled about a point within it, in columns,
/// rows and depth steps, to hold what rounding makes of the quadric over its pixels. Infinite where no bound is known.
double growth_of(const ScreenQuadric& quadric, facet::QuadricSide side, const glm::dvec3& inside, const View& view,
                 const PixelRect& pixels);

/// Narrows an extent to what the quadric's integers leave of its pixels and depths.
void narrow(Extent& extent, const ScreenQuadric& quadric, facet::QuadricSide side, const View& view);

}  // namespace csgsim::view
