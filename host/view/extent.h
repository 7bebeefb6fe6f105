#pragma once

#include "host/view/eye_space.h"
#include "host/view/projection.h"

namespace csgsim::view {

/// The pixels of the picture that a solid's vertices span; `view` has to have its depth scale.
PixelRect pixels_of(const facet::Convex& solid, const EyeSpace& space, const View& view);

/// What a solid can touch in a picture; `view` has to have its planes, its quadrics and its depth scale.
Extent make_extent(const facet::Convex& solid, const EyeSpace& space, const View& view);

}  // namespace csgsim::view
