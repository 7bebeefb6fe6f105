// The transformation of quadrics into screen space.
// Used by the projection.
#pragma once

#include "host/facet/quadric_table.h"
#include "host/view/eye_space.h"
#include "host/view/projection.h"
#include "host/view/screen_quadric.h"

namespace csgsim::view {

/// A canonical quadric in a picture. Its origin is relative to `centre`, and its solids touch only `pixels`. The depth
/// scale of `view` must be set.
ScreenQuadric make_screen_quadric(const EyeSpace& space, const View& view, const facet::Quadric& quadric,
                                  const glm::dvec3& centre, const PixelRect& pixels);

}  // namespace csgsim::view
