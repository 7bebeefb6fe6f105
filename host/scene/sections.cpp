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

constexpr std::array material_keys = joined(
    chosen_keys<MaterialRule>,
    std::array{
        colour_key<&MaterialRule::colour>("colour", "instead of the model's"),
        number_key<&MaterialRule::opacity>("opacity", "", 0, 1, "instead of the model's alpha: 0 is clear, 1 opaque"),
        number_key<&MaterialRule::material, &Material::ambient>("ambient", "", 0, 1,
                                                                "part of the ambient light that it throws back"),
        number_key<&MaterialRule::material, &Material::diffuse>("diffuse", "", 0, 1, "part of a light from the front"),
        number_key<&MaterialRule::material, &Material::specular>("specular", "", 0, 1,
                                                                 "part of a light that is mirrored into the eye"),
        number_key<&MaterialRule::material, &Material::shininess>("shininess", "", 1, 1000,
                                                                  "exponent of the highlight"),
        number_key<&MaterialRule::material, &Material::mirror>(
            "mirror", "", 0, 1, "part of what its flat faces show that is their mirror image; of what is opaque")});

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
  complete(rule);
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
            material_keys, blank_section<MaterialRule>, keep_material}};

}  // namespace

void keep_effect(Scene& scene, const Section& section, std::any&& read) {
  scene.effects.push_back({section.name, std::move(read)});
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
