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

// Not in the unnamed namespace, in which table_of would not find them.
void visit_keys(Camera& camera, auto&& visit) {
  visit(vector_key("eye", "model units", "where the eye is"), camera.eye);
  visit(vector_key("centre", "model units", "what it looks at"), camera.centre);
  visit(choice_key("projection", projections, "how the picture is projected"), camera.is_perspective);
  visit(boolean_key("view_all", "the camera moves so that the whole model just fits"), camera.view_all);
  visit(number_key("near", "model units", 0, any_number,
                   "perspective: distance of the near plane; solids are capped there"),
        camera.near);
}

static void complete(const Camera& camera) {
  if (camera.near && !camera.is_perspective.value_or(false)) {
    throw InputError("near is for a perspective view; add projection = \"perspective\"");
  }
}

void visit_keys(Background& background, auto&& visit) {
  visit(colour_key("colour", "where nothing is seen: red, green, blue"), background.colour);
}

void visit_keys(Ambient& ambient, auto&& visit) {
  visit(colour_key("colour", "red, green, blue"), ambient.colour);
  visit(number_key("intensity", "", 0, 1, "part of the colour that every surface gets"), ambient.intensity);
}

void visit_keys(Light& light, auto&& visit) {
  visit(choice_key("kind", light_kinds, "from far away, or from a place"), light.kind);
  visit(choice_key("axes", axes, "of direction and position; the camera's are right, up and forward"), light.axes);
  visit(vector_key("direction", "", "directional: in which the light shines"), light.direction);
  visit(vector_key("position", "model units", "point: where the light is"), light.position);
  visit(colour_key("colour", "red, green, blue"), light.colour);
  visit(number_key("intensity", "", 0, 10, "part of the colour that a surface gets which faces it"), light.intensity);
}

static void complete(const Light& light) {
  if (light.kind == LightKind::directional && glm::length(light.direction) == 0) {
    throw InputError("a directional light shines in a direction; add direction = [x, y, z], not all 0");
  }
}

void visit_keys(MaterialRule& rule, auto&& visit) {
  visit_keys(static_cast<Chosen&>(rule), visit);
  visit(colour_key("colour", "instead of the model's"), rule.colour);
  visit(number_key("opacity", "", 0, 1, "instead of the model's alpha: 0 is clear, 1 opaque"), rule.opacity);
  Material& material = rule.material;
  visit(number_key("ambient", "", 0, 1, "part of the ambient light that it throws back"), material.ambient);
  visit(number_key("diffuse", "", 0, 1, "part of a light from the front"), material.diffuse);
  visit(number_key("specular", "", 0, 1, "part of a light that is mirrored into the eye"), material.specular);
  visit(number_key("shininess", "", 1, 1000, "exponent of the highlight"), material.shininess);
  visit(
      number_key("mirror", "", 0, 1, "part of what its flat faces show that is their mirror image; of what is opaque"),
      material.mirror);
}

namespace {

constexpr std::array sections{
    section<Camera, &Scene::camera>("camera", "where the model is seen from"),
    section<Background, &Scene::background>("background", "what is seen where there is no solid"),
    section<Ambient, &Scene::ambient>("ambient", "light from everywhere"),
    section<std::vector<Light>, &Scene::lights>("lights", "lights; if there are none, one beside the eye"),
    section<std::vector<MaterialRule>, &Scene::materials>(
        "materials", "how surfaces throw light back; the last that holds for a primitive counts")};

}  // namespace

void call(Scene& scene, const Section& section, Values&& table) {
  std::vector<CalledEffect>& effects = scene.effects;
  if (!section.is_list || effects.empty() || effects.back().name != section.name) effects.push_back({section.name, {}});
  effects.back().tables.push_back(std::move(table));
}

void complete(Chosen& chosen) {
  if (chosen.to_line && !chosen.from_line) throw InputError("to_line without from_line; add from_line");
  if (chosen.from_line && !chosen.to_line) chosen.to_line = chosen.from_line;
  if (chosen.from_line && *chosen.to_line < *chosen.from_line) {
    throw InputError("to_line is before from_line; change them over");
  }
}

std::span<const Section> common_sections() { return sections; }

}  // namespace csgsim::scene
