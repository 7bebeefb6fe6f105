// Reduction of shadow volumes to the planes that must be broadcast. Used by the shadow effect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/effects/shadow_receivers.h"
#include "host/effects/shadow_volumes.h"
#include "hw/base/work.h"

namespace csgsim::effects {

/// The part of a shadow volume that must be broadcast.
struct ShadowPart {
  std::vector<ShadowPlane> planes;
  view::PixelRect pixels;  ///< pixels where it touches receivers
  std::uint32_t primitive = 0;
};

/// Parts that together shadow the same parts of the receivers as a set of volumes.
struct ShadowParts {
  std::vector<ShadowPart> parts;
  std::vector<std::size_t> touched;  ///< indices of the receivers that a part touches
};

/// The volumes that touch receivers, without redundant volumes, each with as few planes as possible: a part may be
/// larger than its volume only where another part covers the excess. `fraction_bits`: fraction bits of surfaces. Throws
/// WorkError if the work limit is exceeded.
ShadowParts find_touching_parts(const std::vector<ShadowVolumeInView>& volumes, const Receivers& receivers,
                                unsigned fraction_bits, const Work& work);

}  // namespace csgsim::effects
