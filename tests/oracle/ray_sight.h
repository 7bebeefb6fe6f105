#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/view/eye_space.h"
#include "tests/oracle/ray_light.h"
#include "tests/oracle/ray_model.h"

namespace csgsim::testing {

/// A mirror.
struct RayMirror {
  std::uint32_t primitive = 0;
  std::optional<std::uint32_t> halfspace;  ///< index into facet::Convex::halfspaces; none for all facets
  double reflectance = 1;                  ///< weight of the reflection in the colour, 0 to 1
};

/// Depth cue: colours fade with the distance along the view axis; those in a mirror with the length of the whole path.
struct RayCue {
  double begin = 0;  ///< distance in model units at which fading begins
  double end = 1;    ///< distance at which only the fading colour remains
  glm::dvec3 colour{0};
};

/// Effects of a picture in addition to shaded facets. By default none.
struct RayEffects {
  bool has_shadows = false;
  std::vector<std::uint32_t> shadowless_lights;  ///< lights that cast no shadows

  std::vector<double> opacity;  ///< 0 to 1, by primitive; empty if all are opaque
  unsigned layers = 1;          ///< maximum number of surfaces visible behind one another
  /// Screen-door: whether a primitive's surfaces are drawn at a pixel (column, row, primitive); if empty, all are.
  std::function<bool(std::uint32_t, std::uint32_t, std::uint32_t)> is_there;

  std::vector<RayMirror> mirrors;  ///< the first match for a facet applies
  unsigned reflections = 0;        ///< maximum number of mirrors in one another; further ones show only their colour

  std::optional<RayCue> cue;  ///< fading of surfaces, not of the background
};

/// The pixel that a ray belongs to, also for rays of mirrored eyes.
struct RayPixel {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};

/// The result of a ray.
struct RaySeen {
  glm::dvec3 colour{0};
  SurfacePoint nearest;             ///< without a primitive for the background
  std::vector<std::uint32_t> path;  ///< all decisions: layers, unshadowed lights, mirrors
  bool is_clear = true;             ///< whether all decisions exceed the gap
};

/// Casts rays.
class RaySight {
 public:
  /// Keeps references. See RayModel for `gap`.
  RaySight(const RayModel& model, const RayLighting& lighting, const RayEffects& effects, const glm::dvec3& background,
           double gap)
      : model_(model), lighting_(lighting), effects_(effects), background_(background), gap_(gap) {}

  /// The result of one of an eye's rays; t is distance along the eye's axis.
  [[nodiscard]] RaySeen look(const view::EyeSpace& eye, const Ray& ray, const Stretch& stretch, RayPixel pixel) const {
    return look(eye, ray, stretch, pixel, effects_.reflections);
  }

 private:
  [[nodiscard]] RaySeen look(const view::EyeSpace& eye, const Ray& ray, const Stretch& stretch, RayPixel pixel,
                             unsigned reflections) const;
  [[nodiscard]] std::vector<bool> unshadowed_lights(const Ray& ray, const SurfacePoint& point, RaySeen& seen) const;
  [[nodiscard]] bool is_blocked(const Ray& ray, const SurfacePoint& point, const RayLight& light, RaySeen& seen) const;
  [[nodiscard]] glm::dvec3 surface(const view::EyeSpace& eye, const Ray& ray, const SurfacePoint& point, RayPixel pixel,
                                   unsigned reflections, RaySeen& seen) const;
  [[nodiscard]] double opacity(std::uint32_t primitive) const;
  [[nodiscard]] double reflectance(const SurfacePoint& point) const;

  const RayModel& model_;
  const RayLighting& lighting_;
  const RayEffects& effects_;
  glm::dvec3 background_;
  double gap_;
};

}  // namespace csgsim::testing
