#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace csgsim::testing {

/// A sphere, or a cylinder about its middle.
struct Solid {
  glm::dvec3 at{0};
  glm::dmat3 axes{1};
  double radius = 1;
  double height = 0;  ///< 0: a sphere

  [[nodiscard]] std::string text() const;
};

struct Case {
  Solid solid;
  std::optional<glm::dvec3> colour;
  std::vector<scene::Light> lights;
  double ambient = 0.3;
  glm::dvec3 eye{0, 0.04, 40};
  unsigned colour_bits = 24;
  unsigned z_bits = 20;
  std::string beside{};  ///< more of the model, that takes no pixels of the solid
};

/// How far the picture is from the law.
struct Errors {
  double levels = 0;  ///< of a channel, the most
  double part = 0;    ///< of what is promised, the most
  int looked_at = 0;
  double sum = 0;  ///< of levels, of channels where every light shines at 0.2 of its most at least: above 0 too light
  int summed = 0;  ///< these channels
  int lit = 0;     ///< of these, channels that are neither ambient light alone nor saturated
};

/// `shines`: the way that its light goes, in the axes of the eye.
scene::Light light(const glm::dvec3& shines, const glm::dvec3& colour, double intensity);

/// Draws the case and holds it against Lambert's law in doubles, at the point where a pixel's ray meets the ball or the
/// round side; adds to `errors`.
void measure(const Case& one, Errors& errors);

}  // namespace csgsim::testing
