#include "tests/oracle/ray_sight.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace csgsim::testing {

namespace {

/// Cosines closer to 0 than this have an uncertain sign; the light they contribute is invisible.
constexpr double edge_on = 1e-9;

glm::dvec3 place_at(const Ray& ray, double t) { return ray.origin + t * ray.direction; }

glm::dvec3 turned_over(const glm::dvec3& v, const glm::dvec3& normal) { return v - 2.0 * glm::dot(v, normal) * normal; }

glm::dvec3 mirrored(const glm::dvec3& place, const glm::dvec3& on_mirror, const glm::dvec3& normal) {
  return on_mirror + turned_over(place - on_mirror, normal);
}

/// The mirrored eye that sees the contents of the mirror.
view::EyeSpace mirrored(view::EyeSpace eye, const glm::dvec3& on_mirror, const glm::dvec3& normal) {
  eye.eye = mirrored(eye.eye, on_mirror, normal);
  for (glm::dvec3* axis : {&eye.axes.right, &eye.axes.up, &eye.axes.forward}) *axis = turned_over(*axis, normal);
  return eye;
}

}  // namespace

double RaySight::opacity(std::uint32_t primitive) const {
  return effects_.opacity.empty() ? 1.0 : effects_.opacity[primitive];
}

double RaySight::reflectance(const SurfacePoint& point) const {
  for (const RayMirror& mirror : effects_.mirrors) {
    const bool is_it =
        mirror.primitive == point.primitive && mirror.halfspace.value_or(point.halfspace) == point.halfspace;
    if (is_it) return mirror.reflectance;
  }
  return 0.0;
}

bool RaySight::is_blocked(const Ray& ray, const SurfacePoint& point, const RayLight& light, RaySeen& seen) const {
  const auto from = [&](double t) {
    const glm::dvec3 place = place_at(ray, t);
    const glm::dvec3 way = light.is_point ? light.place - place : light.direction;
    const double length = light.is_point ? glm::length(way) : std::numeric_limits<double>::infinity();
    return model_.occlusion({place, glm::normalize(way), point.plane}, length, gap_);
  };
  const Occlusion here = from(point.t);
  const auto same = [&](double t) { return from(t).is_blocked == here.is_blocked; };
  const bool is_clear = here.is_clear && (gap_ == 0.0 || (same(point.t - gap_) && same(point.t + gap_)));
  seen.is_clear = seen.is_clear && is_clear;
  return here.is_blocked;
}

std::vector<bool> RaySight::unshadowed_lights(const Ray& ray, const SurfacePoint& point, RaySeen& seen) const {
  const std::vector<RayLight>& lights = lighting_.lights();
  std::vector<bool> counts(lights.size());
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const double cosine_to_light = lighting_.cosine_to_light(point, lights[i]);
    if (std::abs(cosine_to_light) < edge_on && lighting_.has_highlights(point.primitive)) seen.is_clear = false;
    counts[i] = cosine_to_light >= edge_on;
    const auto& shine_through = effects_.shadowless_lights;
    const bool throws_shadows =
        effects_.has_shadows && std::find(shine_through.begin(), shine_through.end(), i) == shine_through.end();
    counts[i] = counts[i] && !(throws_shadows && is_blocked(ray, point, lights[i], seen));
    seen.path.push_back(counts[i] ? 1 : 0);
  }
  return counts;
}

glm::dvec3 RaySight::surface(const view::EyeSpace& eye, const Ray& ray, const SurfacePoint& point, RayPixel pixel,
                             unsigned reflections, RaySeen& seen) const {
  glm::dvec3 colour = lighting_.colour(point, unshadowed_lights(ray, point, seen), eye);
  if (effects_.cue) {
    const double part = (point.t - effects_.cue->begin) / (effects_.cue->end - effects_.cue->begin);
    colour = glm::mix(colour, effects_.cue->colour, std::clamp(part, 0.0, 1.0));
  }
  const double shown = reflections > 0 ? reflectance(point) : 0.0;
  if (shown == 0.0) return colour;
  const glm::dvec3 normal = model_.normal(point.primitive, point.halfspace);
  const glm::dvec3 place = place_at(ray, point.t);
  const Ray reflected{mirrored(ray.origin, place, normal), turned_over(ray.direction, normal)};
  const RaySeen behind = look(mirrored(eye, place, normal), reflected, {point.t, point.plane}, pixel, reflections - 1);
  seen.path.insert(seen.path.end(), behind.path.begin(), behind.path.end());
  seen.is_clear = seen.is_clear && behind.is_clear;
  return glm::mix(colour, behind.colour, shown);
}

RaySeen RaySight::look(const view::EyeSpace& eye, const Ray& ray, const Stretch& stretch, RayPixel pixel,
                       unsigned reflections) const {
  RaySeen seen;
  double left = 1.0;
  unsigned layer = 0;
  const Surfaces surfaces = model_.surfaces(ray, stretch, gap_);
  for (const SurfacePoint& point : surfaces.points) {
    if (left == 0.0 || layer == effects_.layers) break;
    if (effects_.is_there && !effects_.is_there(pixel.x, pixel.y, point.primitive)) continue;
    if (layer++ == 0) seen.nearest = point;
    seen.path.insert(seen.path.end(), {point.primitive, point.halfspace});
    seen.is_clear = seen.is_clear && point.is_clear;
    if (point.halfspace == model::no_index) break;
    const double here = left * opacity(point.primitive);
    seen.colour += here * surface(eye, ray, point, pixel, reflections, seen);
    left -= here;
  }
  const bool is_through = left > 0.0 && layer < effects_.layers;
  seen.is_clear = seen.is_clear && (surfaces.is_clear || !is_through);
  seen.colour += left * background_;
  seen.path.push_back(model::no_index);
  return seen;
}

}  // namespace csgsim::testing
