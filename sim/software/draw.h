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

/// What is seen at each pixel, row by row.
struct Picture {
  std::vector<Seen> seen;
};

/// Draws a picture, a band of rays after another. With `counts`, what rays take is added to them.
Picture draw(const RayCaster& rays, Method& method, RayCounts* counts = nullptr);

/// Seconds of wall time on this computer.
struct Seconds {
  double rays = 0;            ///< intersecting and sorting
  double classification = 0;  ///< of a method that takes planes, all of it
};

/// Draws a picture again and again, until a fifth of a second has passed, five times at most, and takes the time of its
/// parts: the least of each.
Seconds timed(const RayCaster& rays, const std::function<std::unique_ptr<Method>()>& make);

/// Of depth and owner of every pixel.
std::string hash_of(const Picture& picture);

/// What the rays of a picture meet until they get into the solid.
Survey survey(const RayCaster& rays, const Picture& picture);

}  // namespace csgsim::software
