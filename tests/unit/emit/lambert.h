#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace csgsim::testing {

/// A sphere, or a cylinder centred at its middle.
struct Solid {
  glm::dvec3 at{0};
  glm::dmat3 axes{1};
  double radius = 1;
  double height = 0;  ///< 0 for a sphere

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
  std::string beside{};  ///< more geometry that covers no pixels of the solid
};

/// Deviation of the picture from the law.
struct Errors {
  double levels = 0;  ///< maximum of any channel
  double part = 0;    ///< maximum relative to the tolerance
  int checked = 0;
  double sum = 0;  ///< sum of signed errors in levels over channels where every light contributes at least 0.2 of its
                   ///< maximum; positive means too bright
  int summed = 0;  ///< number of these channels
  int lit = 0;     ///< number of these channels that are neither purely ambient nor saturated
};

/// `shines` is the direction of the light in eye axes.
scene::Light light(const glm::dvec3& shines, const glm::dvec3& colour, double intensity);

/// Draws the case and compares it with Lambert's law in doubles where a pixel's ray hits the sphere or the curved side;
/// adds to `errors`.
void measure(const Case& one, Errors& errors);

}  // namespace csgsim::testing
