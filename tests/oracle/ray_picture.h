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

/// How a model is looked at.
struct RayShot {
  view::Camera camera;
  std::uint32_t width = 0;                  ///< pixels
  std::uint32_t height = 0;                 ///< pixels
  double near = 0;                          ///< perspective: distance of the near plane, model units
  std::vector<glm::dvec2> samples{{0, 0}};  ///< from the pixel's centre, columns and rows; several: their mean
};

/// What may be decided otherwise by rounding.
struct RayDoubt {
  /// Pixels. A pixel is certain only if the same is seen, layer by layer, in the same light, by rays that much to
  /// either side of it.
  double aside = 0.01;
  /// Model units along a ray (in perspective: along the view axis): surfaces of different planes that are nearer to one
  /// another, or to something that hides light, are in doubt.
  double gap = 1e-4;
};

/// What a pixel should show.
struct RayColour {
  glm::dvec3 colour{0};                       ///< red, green, blue in [0, 1]; rounded to 8 bits a channel if it has one
                                              ///< sample only after this
  std::uint32_t primitive = model::no_index;  ///< of the nearest surface, by the first sample; none: the background
  std::uint32_t halfspace = model::no_index;  ///< its facet, index into facet::Convex::halfspaces
  double depth = std::numeric_limits<double>::infinity();  ///< distance from the eye along the view axis, model units
  bool is_certain = true;  ///< never where the near plane cuts a solid open: that colour is not told
};

/// The picture of a model in a scene, pixel by pixel in row order, by casting rays: a judge of effects, which shares no
/// arithmetic with what draws them. In double precision; each facet is shaded as a whole. Samples are rounded to 8 bits
/// a channel before their mean is taken; nothing else is.
///
/// Of the scene it takes lights, ambient light, materials and the background; effects are as given, whatever the scene
/// calls for.
std::vector<RayColour> ray_picture(const model::Tree& tree, const facet::Geometry& facets, const scene::Scene& scene,
                                   const RayShot& shot, const RayEffects& effects = {}, const RayDoubt& doubt = {});

/// Levels of 255 by which a colour of 24 bits is off, of the channel that is most.
double off_by(std::uint32_t packed, const glm::dvec3& expected);

}  // namespace csgsim::testing
