#pragma once

#include <cstddef>
#include <vector>

#include "host/effects/outline.h"
#include "host/effects/shadow_volumes.h"
#include "host/emit/context.h"

namespace csgsim::effects {

/// A facet that may be seen in the light, at the depths of its plane.
struct Receiver {
  view::FixedLinear plane;
  Outline outline;  ///< holds its pixels
};

/// What is seen in a region where a light makes a difference.
struct Receivers {
  std::vector<Receiver> facets;
  bool reach_near = false;  ///< something is at depth 0, where the near plane cuts it open
};

Receivers receivers_of(const emit::Context& context, std::size_t light);

/// What has to be broadcast of a volume.
struct ShadowPart {
  std::vector<ShadowPlane> planes;
  view::PixelRect pixels;  ///< where it touches receivers
  std::uint32_t primitive = 0;
};

/// The volumes that touch receivers, with as few planes as take the same of the receivers; none twice, and none that
/// another holds. `fraction_bits`: of surfaces.
std::vector<ShadowPart> parts_that_touch(const std::vector<SeenVolume>& volumes, const Receivers& receivers,
                                         unsigned fraction_bits);

}  // namespace csgsim::effects
