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
constexpr double last_line = 4'294'967'295.0;

constexpr std::array camera_keys{
    vector_key<&Camera::eye>("eye", "model units", "where the eye is"),
    vector_key<&Camera::centre>("centre", "model units", "what it looks at"),
    choice_key<&Camera::is_perspective>("projection", projections, "how the picture is projected"),
    boolean_key<&Camera::view_all>("view_all", "the camera moves so that the whole model just fits"),
    number_key<&Camera::near>("near", "model units", 0, any_number,
                              "perspective: distance of the near plane; solids are capped there")};

constexpr std::array background_keys{
    colour_key<&Background::colour>("colour", "where nothing is seen: red, green, blue")};

constexpr std::array ambient_keys{
    colour_key<&Ambient::colour>("colour", "red, green, blue"),
    number_key<&Ambient::intensity>("intensity", "", 0, 1, "part of the colour that every surface gets")};

constexpr std::array light_keys{
    choice_key<&Light::kind>("kind", light_kinds, "from far away, or from a place"),
    choice_key<&Light::axes>("axes", axes, "of direction and position; the camera's are right, up and forward"),
    vector_key<&Light::direction>("direction", "", "directional: in which the light shines"),
    vector_key<&Light::position>("position", "model units", "point: where the light is"),
    colour_key<&Light::colour>("colour", "red, green, blue"),
    number_key<&Light::intensity>("intensity", "", 0, 10, "part of the colour that a surface gets which faces it")};

constexpr std::array material_keys{
    colour_key<&MaterialRule::of_colour>("of_colour", "for the primitives that have this colour in the model"),
    integer_key<&MaterialRule::from_line>("from_line", "", 1, last_line, "for those from this line of the model on"),
    integer_key<&MaterialRule::to_line>("to_line", "", 1, last_line, "to this line; from_line if not given"),
    colour_key<&MaterialRule::colour>("colour", "instead of the model's"),
    number_key<&MaterialRule::opacity>("opacity", "", 0, 1, "instead of the model's alpha: 0 is clear, 1 opaque")};

struct MaterialRuleKeys {
  template <double Material::*member>
  static constexpr Key number(std::string_view name, double least, double most, std::string_view meaning) {
    return {name,
            ValueKind::number,
            "",
            least,
            most,
            meaning,
            [](std::any& section, const Value& value) {
              std::any_cast<MaterialRule&>(section).material.*member = std::get<double>(value);
            },
            {},
            [](const std::any& section) {
              return std::optional<Value>(std::any_cast<const MaterialRule&>(section).material.*member);
            }};
  }
};

constexpr std::array all_material_keys{
    material_keys[0],
    material_keys[1],
    material_keys[2],
    material_keys[3],
    material_keys[4],
    MaterialRuleKeys::number<&Material::ambient>("ambient", 0, 1, "part of the ambient light that it throws back"),
    MaterialRuleKeys::number<&Material::diffuse>("diffuse", 0, 1, "part of a light from the front"),
    MaterialRuleKeys::number<&Material::specular>("specular", 0, 1, "part of a light that is mirrored into the eye"),
    MaterialRuleKeys::number<&Material::shininess>("shininess", 1, 1000, "exponent of the highlight")};

template <auto member>
void keep_one(Scene& scene, const Section& /*section*/, std::any&& read) {
  auto& kept = scene.*member;
  kept = std::any_cast<std::remove_reference_t<decltype(kept)>>(std::move(read));
}

void keep_camera(Scene& scene, const Section& /*section*/, std::any&& read) {
  const auto& camera = std::any_cast<const Camera&>(read);
  if (camera.near && !camera.is_perspective.value_or(false)) {
    throw InputError("near is for a perspective view; add projection = \"perspective\"");
  }
  scene.camera = camera;
}

void keep_light(Scene& scene, const Section& /*section*/, std::any&& read) {
  const auto& light = std::any_cast<const Light&>(read);
  if (light.kind == LightKind::directional && glm::length(light.direction) == 0) {
    throw InputError("a directional light shines in a direction; add direction = [x, y, z], not all 0");
  }
  scene.lights.push_back(light);
}

void keep_material(Scene& scene, const Section& /*section*/, std::any&& read) {
  auto& rule = std::any_cast<MaterialRule&>(read);
  if (rule.to_line && !rule.from_line) throw InputError("to_line without from_line; add from_line");
  if (rule.from_line && !rule.to_line) rule.to_line = rule.from_line;
  if (rule.from_line && *rule.to_line < *rule.from_line) {
    throw InputError("to_line is before from_line; change them over");
  }
  scene.materials.push_back(rule);
}

constexpr std::array sections{
    Section{"camera", "where the model is seen from", false, camera_keys, blank_section<Camera>, keep_camera},
    Section{"background", "what is seen where there is no solid", false, background_keys, blank_section<Background>,
            keep_one<&Scene::background>},
    Section{"ambient", "light from everywhere", false, ambient_keys, blank_section<Ambient>, keep_one<&Scene::ambient>},
    Section{"lights", "lights; if there are none, one beside the eye", true, light_keys, blank_section<Light>,
            keep_light},
    Section{"materials", "how surfaces throw light back; the last that holds for a primitive counts", true,
            all_material_keys, blank_section<MaterialRule>, keep_material}};

}  // namespace

void keep_effect(Scene& scene, const Section& section, std::any&& read) {
  scene.effects.push_back({section.name, std::move(read)});
}

std::span<const Section> common_sections() { return sections; }

}  // namespace csgsim::scene
