#pragma once

#include <cstdint>
#include <string>

#include "host/view/camera.h"
#include "host/view/projection.h"

namespace csgsim::testing {

/// A scene with curved surfaces in a small picture with few bits.
struct CurvedScene {
  std::string csg;
  view::Camera camera;
  view::Sampling sampling;
};

/// Balls, cylinders, cones, boxes and prisms on a coarse grid, turned by right angles, mirrored, stretched and sheared
/// by powers of two or turned by any angle, so that many surfaces coincide, touch and are seen along their axes; from
/// afar and from within. A seed gives the same scene on every computer.
CurvedScene random_curves(std::uint64_t seed, view::Projection projection);

}  // namespace csgsim::testing
