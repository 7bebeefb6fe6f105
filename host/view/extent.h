// Bounds of solids in a picture.
// Used by the projection.
#pragma once

#include "host/view/eye_space.h"
#include "host/view/projection.h"

namespace csgsim::view {

/// The pixels spanned by a solid's vertices. The depth scale of `view` must be set.
PixelRect vertex_pixels(const facet::Convex& solid, const EyeSpace& space, const View& view);

/// The pixels and depths that a solid can touch. The planes, quadrics and depth scale of `view` must be set.
Extent make_extent(const facet::Convex& solid, const EyeSpace& space, const View& view);

}  // namespace csgsim::view
