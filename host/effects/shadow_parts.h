#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/effects/shadow_receivers.h"
#include "host/effects/shadow_volumes.h"
#include "hw/base/work.h"

namespace csgsim::effects {

/// What has to be broadcast of a volume.
struct ShadowPart {
  std::vector<ShadowPlane> planes;
  view::PixelRect pixels;  ///< where it touches receivers
  std::uint32_t primitive = 0;
};

/// What takes the same of the receivers as some volumes together.
struct ShadowParts {
  std::vector<ShadowPart> parts;
  std::vector<std::size_t> touched;  ///< receivers, by their index
};

/// The volumes that touch receivers, but for those that take nothing that others do not take, each with as few planes
/// as will do: what one takes too much, another one takes anyway. `fraction_bits`: of surfaces. Throws WorkError past
/// the limit on work.
ShadowParts parts_that_touch(const std::vector<SeenVolume>& volumes, const Receivers& receivers, unsigned fraction_bits,
                             const Work& work);

}  // namespace csgsim::effects
