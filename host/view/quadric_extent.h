// Bounds of quadrics, including rounding. Used by the extents of solids.
#pragma once

#include <glm/vec3.hpp>

#include "host/facet/quadric_table.h"
#include "host/view/projection.h"

namespace csgsim::view {

/// The factor by which a solid bounded by this side of a quadric must grow about a point inside it (in columns, rows
/// and depth steps) to contain the rounded quadric over its pixels. Infinite if no bound is known.
double required_growth(const ScreenQuadric& quadric, facet::QuadricSide side, const glm::dvec3& inside,
                       const View& view, const PixelRect& pixels);

/// Narrows an extent to the pixels and depths that the quadric's integers allow.
void narrow_to_quadric(Extent& extent, const ScreenQuadric& quadric, facet::QuadricSide side, const View& view);

}  // namespace csgsim::view
