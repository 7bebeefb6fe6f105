// Drawing of pictures by a classification method.
// Used by sim/studies.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/software/methods/method.h"
#include "sim/software/rays/caster.h"
#include "sim/software/survey.h"

namespace csgsim::software {

/// The visible surface at each pixel, row by row.
struct Picture {
  std::vector<VisibleSurface> seen;
};

/// Draws a picture band by band. If `counts` is given, the cost of the rays is added to it.
Picture draw(const RayCaster& rays, Method& method, RayCounts* counts = nullptr);

/// Wall time on this computer in seconds.
struct Seconds {
  double rays = 0;            ///< seconds to intersect rays and to sort their events
  double classification = 0;  ///< for a method that takes planes, the total time
};

/// Draws the picture repeatedly, up to five times or until 0.2 seconds have passed, and returns the minimum time of
/// each part.
Seconds measure_seconds(const RayCaster& rays, const std::function<std::unique_ptr<Method>()>& make);

/// Hash of depth and owner of every pixel.
std::string hash_of(const Picture& picture);

/// Statistics of the rays of a picture up to the point at which they enter the solid.
Survey survey(const RayCaster& rays, const Picture& picture);

}  // namespace csgsim::software
