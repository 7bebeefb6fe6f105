#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/scene/scene.h"
#include "host/view/camera.h"
#include "tests/oracle/ray_sight.h"

namespace csgsim::testing {

/// Camera and picture size.
struct RayShot {
  view::Camera camera;
  std::uint32_t width = 0;   ///< in pixels
  std::uint32_t height = 0;  ///< in pixels
  double near = 0;           ///< distance of the near plane in model units (perspective)
  std::vector<glm::dvec2> samples{
      {0, 0}};  ///< offsets from the pixel's centre in columns and rows; several are averaged
};

/// Tolerances for decisions that depend on rounding.
struct RayDoubt {
  /// Distance in pixels. A pixel is certain only if rays at this distance on either side see the same layers in the
  /// same light.
  double aside = 0.01;
  /// Distance in model units along a ray (in perspective along the view axis). Surfaces of different planes that are
  /// closer than this to one another, or to an occluder, are uncertain.
  double gap = 1e-4;
};

/// The expected contents of a pixel.
struct RayColour {
  glm::dvec3 colour{0};  ///< red, green, blue in [0, 1]; with a single sample not rounded to 8 bits per channel
  std::uint32_t primitive = model::no_index;               ///< owner of the nearest surface in the first sample, if any
  std::uint32_t halfspace = model::no_index;               ///< its facet, index into facet::Convex::halfspaces
  double depth = std::numeric_limits<double>::infinity();  ///< distance along the view axis, in model units
  bool is_certain = true;  ///< false for cuts by the near plane, whose colour is unspecified
};

/// The picture of a model in a scene, pixel by pixel in row order, by ray casting: an independent judge of effects,
/// which shares no arithmetic with the code that draws them. In double precision; each facet is shaded as a whole.
/// Samples are rounded to 8 bits per channel before they are averaged; nothing else is rounded.
///
/// Uses the scene's lights, ambient light, materials and background. `effects` replaces the effects of the scene.
std::vector<RayColour> ray_picture(const model::Tree& tree, const facet::Geometry& facets, const scene::Scene& scene,
                                   const RayShot& shot, const RayEffects& effects = {}, const RayDoubt& doubt = {});

/// Largest error of a channel of a 24-bit colour, in levels of 255.
double colour_error(std::uint32_t packed, const glm::dvec3& expected);

}  // namespace csgsim::testing
