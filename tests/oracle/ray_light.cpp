#include "tests/oracle/ray_light.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace csgsim::testing {

namespace {

constexpr glm::dvec3 usual_colour{0.976, 0.843, 0.173};
constexpr glm::dvec3 usual_cut_colour{0.616, 0.796, 0.318};

/// The default light, from the upper left behind the eye.
scene::Light usual_light() {
  scene::Light light;
  light.axes = scene::Axes::camera;
  light.direction = {0.36, -0.56, 0.75};
  return light;
}

RayLight in_model_space(const scene::Light& light, const view::EyeSpace& camera) {
  const bool of_camera = light.axes == scene::Axes::camera;
  const glm::dvec3 shines = of_camera ? camera.to_model(light.direction) - camera.to_model({0, 0, 0}) : light.direction;
  RayLight found;
  found.is_point = light.kind == scene::LightKind::point;
  found.colour = light.colour * light.intensity;
  if (found.is_point) {
    found.place = of_camera ? camera.to_model(light.position) : light.position;
  } else {
    found.direction = -glm::normalize(shines);
  }
  return found;
}

bool is_of(const scene::MaterialRule& rule, const model::Primitive& primitive) {
  constexpr double as_written = 1e-6;
  if (rule.of_colour) {
    if (!primitive.colour) return false;
    for (int channel = 0; channel < 3; ++channel) {
      if (std::abs((*rule.of_colour)[channel] - (*primitive.colour)[channel]) >= as_written) return false;
    }
  }
  if (!rule.from_line && !rule.to_line) return true;
  const std::uint32_t first = rule.from_line.value_or(0);
  return first <= primitive.location.line && primitive.location.line <= rule.to_line.value_or(first);
}

RayFinish finish(const scene::Scene& scene, const model::Primitive& primitive, bool is_cut) {
  RayFinish found{primitive.colour.value_or(is_cut ? usual_cut_colour : usual_colour), {}};
  const auto last = std::find_if(scene.materials.rbegin(), scene.materials.rend(),
                                 [&](const scene::MaterialRule& rule) { return is_of(rule, primitive); });
  if (last == scene.materials.rend()) return found;
  found.material = last->material;
  found.colour = last->colour.value_or(found.colour);
  return found;
}

/// The mean of a solid's vertices on a plane.
glm::dvec3 middle_on(const facet::Convex& solid, const facet::Plane& plane, const glm::dvec3& centre) {
  const double on_it = 1e-8 * (glm::length(solid.box.high - solid.box.low) + glm::length(solid.box.centre() - centre));
  glm::dvec3 sum(0);
  double count = 0;
  for (const glm::dvec3& vertex : solid.vertices) {
    if (std::abs(glm::dot(plane.normal, vertex - centre) + plane.offset) > on_it) continue;
    sum += vertex;
    count += 1.0;
  }
  return sum / count;
}

}  // namespace

RayLighting::RayLighting(const model::Tree& tree, const facet::Geometry& facets, const RayModel& model,
                         const scene::Scene& scene, const view::EyeSpace& camera)
    : model_(model), ambient_(scene.ambient.colour * scene.ambient.intensity) {
  for (const scene::Light& light : scene.lights) lights_.push_back(in_model_space(light, camera));
  if (lights_.empty()) lights_.push_back(in_model_space(usual_light(), camera));
  for (std::uint32_t p = 0; p < tree.primitives.size(); ++p) {
    finishes_.push_back(finish(scene, tree.primitives[p], model.is_subtracted(p)));
    std::vector<glm::dvec3>& middles = middles_.emplace_back();
    for (const facet::Halfspace& halfspace : facets.solids[p].halfspaces) {
      const facet::Plane& plane = facets.planes.planes()[halfspace.plane];
      middles.push_back(middle_on(facets.solids[p], plane, facets.planes.centre()));
    }
  }
}

glm::dvec3 RayLighting::direction_to(const SurfacePoint& facet, const RayLight& light) const {
  return light.is_point ? glm::normalize(light.place - middle(facet)) : light.direction;
}

double RayLighting::cosine_to_light(const SurfacePoint& facet, const RayLight& light) const {
  return glm::dot(model_.normal(facet.primitive, facet.halfspace), direction_to(facet, light));
}

glm::dvec3 RayLighting::colour(const SurfacePoint& facet, const std::vector<bool>& counts,
                               const view::EyeSpace& eye) const {
  const RayFinish& finish = finishes_[facet.primitive];
  const scene::Material& material = finish.material;
  const glm::dvec3 normal = model_.normal(facet.primitive, facet.halfspace);
  const glm::dvec3 to_eye = eye.perspective ? glm::normalize(eye.eye - middle(facet)) : -eye.axes.forward;
  glm::dvec3 colour = finish.colour * ambient_ * material.ambient;
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const double cosine = cosine_to_light(facet, lights_[i]);
    if (!counts[i] || !(cosine > 0.0)) continue;
    colour += finish.colour * lights_[i].colour * (material.diffuse * cosine);
    if (material.specular == 0.0) continue;
    const glm::dvec3 halfway = glm::normalize(direction_to(facet, lights_[i]) + to_eye);
    const double highlight = std::max(0.0, glm::dot(normal, halfway));
    colour += lights_[i].colour * (material.specular * std::pow(highlight, material.shininess));
  }
  return glm::clamp(colour, 0.0, 1.0);
}

}  // namespace csgsim::testing
