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

/// Pixels either side of the middle of a stage's picture.
inline constexpr std::int32_t stage_half = 12;

/// A model seen along +y, orthographically, from the distance at which a pixel is one model unit: the pixel (x, z) of
/// the stage is that through the model's (x, any y, z).
class Stage {
 public:
  explicit Stage(const std::string& csg, scene::Scene scene = {});

  void cast(const RayEffects& effects = {}, const RayDoubt& doubt = {});
  [[nodiscard]] const RayColour& at(std::int32_t x, std::int32_t z) const;

  /// The y at which a pixel's surface is.
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

std::string coloured(const glm::dvec3& colour, const std::string& csg);

/// Ambient light alone: every surface has its own colour. Black behind all.
scene::Scene plain_colours();

/// A light of intensity 0.7 that shines in that direction, beside the usual ambient light of 0.3.
scene::Light shining(const glm::dvec3& direction);

/// The light and the usual ambient light.
scene::Scene lit_by(const scene::Light& light);

/// Whether colours are equal but for rounding of doubles.
bool is_near(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace csgsim::testing
