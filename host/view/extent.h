#pragma once

#include "host/view/eye_space.h"
#include "host/view/projection.h"

namespace csgsim::view {

/// What a solid can touch in a picture; `view` has to have its planes and its depth scale.
Extent make_extent(const facet::Convex& solid, const EyeSpace& space, const View& view);

}  // namespace csgsim::view
