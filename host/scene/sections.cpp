#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "host/scene/schema.h"
#include "hw/base/error.h"

namespace csgsim::scene {

namespace {

constexpr std::array<std::string_view, 2> projections{"ortho", "perspective"};
constexpr std::array<std::string_view, 2> light_kinds{"directional", "point"};
constexpr std::array<std::string_view, 2> axes{"model", "camera"};

}  // namespace

// Declared outside the unnamed namespace so that table_of() finds them.
void visit_keys(Camera& camera, auto&& visit) {
  visit(vector_key("eye", "model units", "position of the eye"), camera.eye);
  visit(vector_key("centre", "model units", "point at which the camera looks"), camera.centre);
  visit(choice_key("projection", projections, "projection of the picture"), camera.is_perspective);
  visit(boolean_key("view_all", "the camera moves so that the whole model just fits"), camera.view_all);
  visit(number_key("near", "model units", 0, coordinate_limit,
                   "perspective: distance of the near plane; solids are capped there"),
        camera.near);
}

static void complete(const Camera& camera) {
  if (camera.near && !camera.is_perspective.value_or(false)) {
    throw InputError("near requires a perspective view; add projection = \"perspective\"");
  }
}

void visit_keys(Background& background, auto&& visit) {
  visit(colour_key("colour", "colour of empty pixels: red, green, blue"), background.colour);
}

void visit_keys(Ambient& ambient, auto&& visit) {
  visit(colour_key("colour", "red, green, blue"), ambient.colour);
  visit(number_key("intensity", "", 0, 1, "fraction of its colour that every surface receives"), ambient.intensity);
}

void visit_keys(Light& light, auto&& visit) {
  visit(choice_key("kind", light_kinds, "infinitely far away, or at a position"), light.kind);
  visit(choice_key("axes", axes, "axes of direction and position; the camera's are right, up and forward"), light.axes);
  visit(vector_key("direction", "", "directional: direction in which the light shines"), light.direction);
  visit(vector_key("position", "model units", "point: position of the light"), light.position);
  visit(colour_key("colour", "red, green, blue"), light.colour);
  visit(number_key("intensity", "", 0, 10, "fraction of its colour that a surface facing the light receives"),
        light.intensity);
}

static void complete(const Light& light) {
  if (light.kind == LightKind::directional && glm::length(light.direction) == 0) {
    throw InputError("a directional light needs a direction; add direction = [x, y, z], not all 0");
  }
}

void visit_keys(MaterialRule& rule, auto&& visit) {
  visit_keys(static_cast<PrimitiveSelection&>(rule), visit);
  visit(colour_key("colour", "replaces the model's colour"), rule.colour);
  visit(number_key("opacity", "", 0, 1, "replaces the model's alpha: 0 is clear, 1 opaque"), rule.opacity);
  Material& material = rule.material;
  visit(number_key("ambient", "", 0, 1, "fraction of the ambient light that the surface reflects"), material.ambient);
  visit(number_key("diffuse", "", 0, 1, "fraction of a light from the front that the surface reflects"),
        material.diffuse);
  visit(number_key("specular", "", 0, 1, "fraction of a light that is reflected to the eye"), material.specular);
  visit(number_key("shininess", "", 1, 1000, "exponent of the highlight"), material.shininess);
  visit(number_key("mirror", "", 0, 1, "fraction of a flat face's colour that is its mirror image; opaque solids only"),
        material.mirror);
}

namespace {

constexpr std::array sections{
    section<Camera, &Scene::camera>("camera", "viewpoint and projection"),
    section<Background, &Scene::background>("background", "colour where there is no solid"),
    section<Ambient, &Scene::ambient>("ambient", "ambient light"),
    section<std::vector<Light>, &Scene::lights>("lights", "lights; the default is one next to the eye"),
    section<std::vector<MaterialRule>, &Scene::materials>(
        "materials", "reflection of surfaces; the last entry that matches a primitive wins")};

}  // namespace

void add_effect_table(Scene& scene, const Section& section, Values&& table) {
  std::vector<EffectRequest>& effects = scene.effects;
  if (!section.is_list || effects.empty() || effects.back().name != section.name) effects.push_back({section.name, {}});
  effects.back().tables.push_back(std::move(table));
}

void complete(PrimitiveSelection& chosen) {
  if (chosen.to_line && !chosen.from_line) throw InputError("to_line without from_line; add from_line");
  if (chosen.from_line && !chosen.to_line) chosen.to_line = chosen.from_line;
  if (chosen.from_line && *chosen.to_line < *chosen.from_line) {
    throw InputError("to_line precedes from_line; set it to from_line or more");
  }
}

std::span<const Section> common_sections() { return sections; }

}  // namespace csgsim::scene
