#pragma once

#include <cstdint>
#include <string>

#include "host/view/camera.h"
#include "host/view/projection.h"

namespace csgsim::testing {

/// A scene with curved surfaces in a picture of few pixels and few bits.
struct CurvedScene {
  std::string csg;
  view::Camera camera;
  view::Sampling sampling;
};

/// Balls, cylinders, cones, boxes and polygons' prisms on a coarse grid, turned by right angles, mirrored, stretched
/// and sheared by powers of two or turned by any angle, so that many surfaces coincide, touch and are seen along their
/// axes; from afar and from within. The same seed gives the same scene everywhere.
CurvedScene random_curves(std::uint64_t seed, view::Projection projection);

}  // namespace csgsim::testing
