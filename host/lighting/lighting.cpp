#include "host/lighting/lighting.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace csgsim::lighting {

namespace {

const scene::Light default_light{
    .kind = scene::LightKind::directional, .axes = scene::Axes::camera, .direction = {0.36, -0.56, 0.75}};

/// Whether two colours of a model are equal within the precision with which they are written.
bool same_colour(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 difference = glm::abs(a - b);
  return std::max({difference.x, difference.y, difference.z}) < 1e-6;
}

glm::dvec3 turned(const glm::dvec3& direction, const view::Basis& axes) {
  return {glm::dot(direction, axes.right), glm::dot(direction, axes.up), glm::dot(direction, axes.forward)};
}

CameraSpaceLight seen_light(const scene::Light& light, const view::Camera& camera) {
  CameraSpaceLight result{light.kind == scene::LightKind::point, {}, light.colour * light.intensity};
  const bool in_model = light.axes == scene::Axes::model;
  if (result.is_point) {
    result.where = in_model ? turned(light.position - camera.eye, view::basis(camera)) : light.position;
  } else {
    result.where = glm::normalize(-(in_model ? turned(light.direction, view::basis(camera)) : light.direction));
  }
  return result;
}

}  // namespace

bool Lighting::is_local(const scene::Material& material) const {
  const bool has_points =
      std::any_of(lights.begin(), lights.end(), [](const CameraSpaceLight& one) { return one.is_point; });
  return has_points || (material.specular > 0 && is_perspective);
}

bool is_selected(const scene::PrimitiveSelection& selection, const model::Primitive& primitive) {
  if (selection.of_colour && !(primitive.colour && same_colour(*selection.of_colour, *primitive.colour))) return false;
  return !selection.from_line || (primitive.location.line >= *selection.from_line &&
                                  primitive.location.line <= selection.to_line.value_or(*selection.from_line));
}

Lighting make_lighting(const scene::Scene& scene, const view::Camera& camera) {
  Lighting lighting;
  lighting.ambient = scene.ambient.colour * scene.ambient.intensity;
  lighting.is_perspective = camera.projection == view::Projection::perspective;
  for (const scene::Light& light : scene.lights) lighting.lights.push_back(seen_light(light, camera));
  if (scene.lights.empty()) lighting.lights.push_back(seen_light(default_light, camera));
  return lighting;
}

glm::dvec3 lit_colour(const Lighting& lighting, const scene::Material& material, const glm::dvec3& colour,
                      const SurfacePoint& point) {
  glm::dvec3 light = lighting.ambient * material.ambient;
  glm::dvec3 highlights{0};
  for (const CameraSpaceLight& one : lighting.lights) {
    const glm::dvec3 to_light = one.is_point ? glm::normalize(one.where - point.place) : one.where;
    const double cosine = glm::dot(to_light, point.normal);
    if (!(cosine > 0)) continue;
    light += one.colour * (material.diffuse * cosine);
    if (material.specular == 0) continue;
    const glm::dvec3 to_eye = lighting.is_perspective ? -glm::normalize(point.place) : glm::dvec3(0, 0, -1);
    const double highlight = std::max(0.0, glm::dot(glm::normalize(to_light + to_eye), point.normal));
    highlights += one.colour * (material.specular * std::pow(highlight, material.shininess));
  }
  return colour * light + highlights;
}

Finish make_finish(const scene::Scene& scene, const model::Primitive& primitive, bool is_cut) {
  const scene::Uncoloured& usual = scene.uncoloured;
  const glm::dvec3 uncoloured =
      is_cut ? usual.cut_face.value_or(default_cut_colour) : usual.face.value_or(default_colour);
  Finish finish{primitive.colour.value_or(uncoloured), {}, primitive.opacity};
  for (const scene::MaterialRule& rule : scene.materials) {
    if (!is_selected(rule, primitive)) continue;
    finish.material = rule.material;
    finish.colour = rule.colour.value_or(finish.colour);
    finish.opacity = rule.opacity.value_or(finish.opacity);
  }
  return finish;
}

}  // namespace csgsim::lighting
