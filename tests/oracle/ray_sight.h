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

/// What reflects.
struct RayMirror {
  std::uint32_t primitive = 0;
  std::optional<std::uint32_t> halfspace;  ///< index into facet::Convex::halfspaces; none: all facets
  double reflectance = 1;                  ///< part of the colour that is what the mirror shows, 0 to 1
};

/// Colours fade into one colour with the distance along the view axis; of what a mirror shows, with the whole way.
struct RayCue {
  double begin = 0;  ///< distance of the eye, model units: not faded
  double end = 1;    ///< nothing else is left
  glm::dvec3 colour{0};
};

/// What a picture shows besides shaded facets. As it is: nothing.
struct RayEffects {
  bool has_shadows = false;
  std::vector<std::uint32_t> shadowless_lights;  ///< that shine through everything

  std::vector<double> opacity;  ///< 0 to 1, one a primitive; none: all are opaque
  unsigned layers = 1;          ///< surfaces that are seen at most behind one another, if the first are not opaque
  /// Screen-door: whether a primitive's surfaces are there at a pixel (column, row, primitive); none: all are.
  std::function<bool(std::uint32_t, std::uint32_t, std::uint32_t)> is_there;

  std::vector<RayMirror> mirrors;  ///< the first that holds for a facet counts
  unsigned reflections = 0;        ///< mirrors that are seen in one another; after so many only their own colour

  std::optional<RayCue> cue;  ///< of surfaces, not of the background
};

/// What a pixel is about, whoever it is seen by.
struct RayPixel {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};

/// What is seen along a ray.
struct RaySeen {
  glm::dvec3 colour{0};
  SurfacePoint nearest;             ///< no primitive where nothing is seen
  std::vector<std::uint32_t> path;  ///< every decision on the way: layers, lights that count, mirrors
  bool is_clear = true;             ///< none of them by less than the gap
};

/// Looks along rays.
class RaySight {
 public:
  /// Keeps references. `gap`: see RayModel.
  RaySight(const RayModel& model, const RayLighting& lighting, const RayEffects& effects, const glm::dvec3& background,
           double gap)
      : model_(model), lighting_(lighting), effects_(effects), background_(background), gap_(gap) {}

  /// What an eye sees along one of its rays; t counts distance along its axis.
  [[nodiscard]] RaySeen look(const view::EyeSpace& eye, const Ray& ray, const Stretch& stretch, RayPixel pixel) const {
    return look(eye, ray, stretch, pixel, effects_.reflections);
  }

 private:
  [[nodiscard]] RaySeen look(const view::EyeSpace& eye, const Ray& ray, const Stretch& stretch, RayPixel pixel,
                             unsigned reflections) const;
  [[nodiscard]] std::vector<bool> lights_at(const Ray& ray, const SurfacePoint& point, RaySeen& seen) const;
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
