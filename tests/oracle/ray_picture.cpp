#include "tests/oracle/ray_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "host/view/projection.h"

namespace csgsim::testing {

namespace {

constexpr glm::dvec3 usual_background{1.0, 1.0, 0.898};

view::EyeSpace eye_of(const RayShot& shot) {
  view::Sampling sampling;
  sampling.width = shot.width;
  sampling.height = shot.height;
  return view::eye_space(shot.camera, sampling);
}

/// The ray at a place in the picture; t is distance along the view axis.
Ray ray_at(const view::EyeSpace& eye, const glm::dvec2& place) {
  const glm::dvec3 away = eye.to_model(eye.from_picture({place.x, place.y, 1}));
  if (eye.perspective) return {eye.eye, away - eye.eye};
  return {eye.to_model(eye.from_picture({place.x, place.y, 0})), eye.axes.forward};
}

class Camera {
 public:
  /// `around` casts the neighbouring rays, with a gap of 0, as they only have to give equal results.
  Camera(const RaySight& sight, const RaySight& around, const RayShot& shot, double aside)
      : sight_(sight), around_(around), shot_(shot), eye_(eye_of(shot)), aside_(aside) {}

  [[nodiscard]] RayColour pixel(RayPixel pixel) const {
    RayColour found;
    const bool has_mean = shot_.samples.size() > 1;
    for (std::size_t i = 0; i < shot_.samples.size(); ++i) {
      const glm::dvec2 place = glm::dvec2(pixel.x, pixel.y) + shot_.samples[i];
      const RaySeen seen = look(sight_, place, pixel);
      found.colour += has_mean ? glm::round(seen.colour * 255.0) / 255.0 : seen.colour;
      found.is_certain = found.is_certain && seen.is_clear && is_same_around(seen, place, pixel);
      if (i > 0 || seen.nearest.primitive == model::no_index) continue;
      found.primitive = seen.nearest.primitive;
      found.halfspace = seen.nearest.halfspace;
      found.depth = seen.nearest.t;
    }
    found.colour /= static_cast<double>(shot_.samples.size());
    return found;
  }

 private:
  [[nodiscard]] RaySeen look(const RaySight& sight, const glm::dvec2& place, RayPixel pixel) const {
    const double from = eye_.perspective ? shot_.near : -std::numeric_limits<double>::infinity();
    return sight.look(eye_, ray_at(eye_, place), {from}, pixel);
  }

  [[nodiscard]] bool is_same_around(const RaySeen& seen, const glm::dvec2& place, RayPixel pixel) const {
    static constexpr std::array<glm::dvec2, 4> corners{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
    for (const glm::dvec2& corner : corners) {
      if (look(around_, place + aside_ * corner, pixel).path != seen.path) return false;
    }
    return true;
  }

  const RaySight& sight_;
  const RaySight& around_;
  const RayShot& shot_;
  view::EyeSpace eye_;
  double aside_;
};

}  // namespace

std::vector<RayColour> ray_picture(const model::Tree& tree, const facet::Geometry& facets, const scene::Scene& scene,
                                   const RayShot& shot, const RayEffects& effects, const RayDoubt& doubt) {
  const RayModel model(tree, facets);
  const RayLighting lighting(tree, facets, model, scene, eye_of(shot));
  const glm::dvec3 background = scene.background.colour.value_or(usual_background);
  const RaySight sight(model, lighting, effects, background, doubt.gap);
  const RaySight around(model, lighting, effects, background, 0);
  const Camera camera(sight, around, shot, doubt.aside);
  std::vector<RayColour> picture;
  picture.reserve(std::size_t{shot.width} * shot.height);
  for (std::uint32_t y = 0; y < shot.height; ++y) {
    for (std::uint32_t x = 0; x < shot.width; ++x) picture.push_back(camera.pixel({x, y}));
  }
  return picture;
}

double colour_error(std::uint32_t packed, const glm::dvec3& expected) {
  const glm::dvec3 levels{packed >> 16U & 0xffU, packed >> 8U & 0xffU, packed & 0xffU};
  const glm::dvec3 off = glm::abs(levels - 255.0 * expected);
  return std::max({off.x, off.y, off.z});
}

}  // namespace csgsim::testing
