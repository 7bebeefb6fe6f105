#pragma once

#include "host/facet/quadric_table.h"
#include "host/view/eye_space.h"
#include "host/view/projection.h"
#include "host/view/screen_quadric.h"

namespace csgsim::view {

/// A canonical quadric in a picture, its origin relative to `centre`, whose solids touch no more than `pixels`. `view`
/// has to have its depth scale.
ScreenQuadric make_screen_quadric(const EyeSpace& space, const View& view, const facet::Quadric& quadric,
                                  const glm::dvec3& centre, const PixelRect& pixels);

}  // namespace csgsim::view
