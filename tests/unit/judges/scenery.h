#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "sim/judges/truth.h"

namespace csgsim::testing {

/// A model with a camera, without a Program.
struct Scenery {
  model::Tree tree;
  facet::Geometry scene;
  view::Camera camera;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  double near = 1;  ///< distance of the near plane in perspective, in model units
};

struct Size {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

Scenery make_scenery(const std::string& csg, const view::Camera& camera, Size size, double near = 1);

/// Keeps spheres, cylinders and cones as quadrics.
Scenery make_curved_scenery(const std::string& csg, const view::Camera& camera, Size size, double near = 1);

judges::Truth exact(const Scenery& scenery);
judges::Truth analytic(const Scenery& scenery);

/// Camera along +y towards the origin, x to the right and z upward, at the distance where a pixel of a picture of the
/// given height is one model unit (at the origin, in perspective).
view::Camera straight_camera(std::uint32_t height, view::Projection projection = view::Projection::orthographic);

/// Distance in model units from the eye of that camera to the origin.
double straight_distance(std::uint32_t height);

/// Owners as digits, a point for background, one line per row.
std::string owners(const judges::Truth& truth);

/// Distance in model units along the view axis from the eye to the owner's surface, in plain doubles: the farthest of
/// its front planes, or the nearest of its back planes if it is subtracted.
double distance_in_doubles(const Scenery& scenery, std::uint32_t column, std::uint32_t row, std::uint32_t owner);

}  // namespace csgsim::testing
