// Simplification of shadow volumes to what must be broadcast.
// Used by the shadow effect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/effects/shadow_receivers.h"
#include "host/effects/shadow_volumes.h"
#include "hw/base/work.h"

namespace csgsim::effects {

/// What must be broadcast of a volume.
struct ShadowPart {
  std::vector<ShadowPlane> planes;
  view::PixelRect pixels;  ///< pixels where it touches receivers
  std::uint32_t primitive = 0;
};

/// Parts that cover the same of the receivers as a set of volumes.
struct ShadowParts {
  std::vector<ShadowPart> parts;
  std::vector<std::size_t> touched;  ///< indices of touched receivers
};

/// The volumes that touch receivers, without redundant ones, each with as few planes as possible: what a part covers in
/// excess is covered by another part anyway. `fraction_bits`: fraction bits of surfaces. Throws WorkError if the work
/// limit is exceeded.
ShadowParts touching_parts(const std::vector<SeenVolume>& volumes, const Receivers& receivers, unsigned fraction_bits,
                           const Work& work);

}  // namespace csgsim::effects
