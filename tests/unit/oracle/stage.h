#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/scene/scene.h"
#include "tests/oracle/ray_picture.h"

namespace csgsim::testing {

/// Pixels on either side of the middle of a stage's picture.
inline constexpr std::int32_t stage_half = 12;

/// A model seen along +y, orthographically, from the distance at which a pixel is one model unit: the stage's pixel (x,
/// z) is the ray through the model's (x, any y, z).
class Stage {
 public:
  explicit Stage(const std::string& csg, scene::Scene scene = {});

  void cast(const RayEffects& effects = {}, const RayDoubt& doubt = {});
  [[nodiscard]] const RayColour& at(std::int32_t x, std::int32_t z) const;

  /// Returns the y of a pixel's surface.
  [[nodiscard]] double y_at(std::int32_t x, std::int32_t z) const { return at(x, z).depth - distance_; }

  scene::Scene scene;
  RayShot shot;
  model::Tree tree;
  facet::Geometry facets;

 private:
  double distance_;
  std::vector<RayColour> picture_;
};

/// A box from one corner to the other, as OpenSCAD prints it.
std::string box(const glm::dvec3& low, const glm::dvec3& high);

std::string with_colour(const glm::dvec3& colour, const std::string& csg);

/// A scene with ambient light only: every surface has its own colour on a black background.
scene::Scene plain_colours();

/// A light of intensity 0.7 in the given direction, in addition to the default ambient light of 0.3.
scene::Light white_light(const glm::dvec3& direction);

/// A scene with the light and the default ambient light.
scene::Scene scene_with_light(const scene::Light& light);

/// Whether two colours are equal up to rounding of doubles.
bool is_near(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace csgsim::testing
