// Scene data: camera, lights, materials, background, effects.
// Used by schema.h, host/effects, host/emit, host/lighting, sim/session and sim/studies.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/values.h"

namespace csgsim::scene {

/// The coordinate system of a direction or position.
enum class Axes : std::uint8_t {
  model,
  camera,  ///< right, up and forward, with the eye at the origin
};

enum class LightKind : std::uint8_t { directional, point };

struct Light {
  LightKind kind = LightKind::directional;
  Axes axes = Axes::model;
  glm::dvec3 direction{0};  ///< directional light: direction in which the light travels, of any length
  glm::dvec3 position{0};   ///< point light: in model units
  glm::dvec3 colour{1};     ///< red, green, blue, each from 0 to 1
  double intensity = 0.7;   ///< fraction of `colour` received by a surface that faces the light

  bool operator==(const Light&) const = default;
};

/// Ambient light.
struct Ambient {
  glm::dvec3 colour{1};
  double intensity = 0.3;

  bool operator==(const Ambient&) const = default;
};

/// The reflection properties of a surface.
struct Material {
  double ambient = 1;     ///< fraction of the ambient light
  double diffuse = 1;     ///< fraction of a light along the normal that is reflected diffusely
  double specular = 0;    ///< fraction of a light that is reflected to the eye, in the colour of the light
  double shininess = 20;  ///< exponent of the highlight (Blinn); larger values make it smaller
  double mirror = 0;      ///< fraction of a flat face's colour that is its mirror image; 1 is a perfect mirror

  bool operator==(const Material&) const = default;
};

/// A selection of primitives: those with a given colour, those from a range of lines of the model's file, or all
/// primitives if neither is given.
struct PrimitiveSelection {
  std::optional<glm::dvec3> of_colour;     ///< colour in the model
  std::optional<std::uint32_t> from_line;  ///< first line of the model's file
  std::optional<std::uint32_t> to_line;    ///< inclusive; defaults to from_line

  bool operator==(const PrimitiveSelection&) const = default;
};

/// A material and the primitives to which it applies. The last matching rule wins.
struct MaterialRule : PrimitiveSelection {
  std::optional<glm::dvec3> colour;  ///< replaces the model's colour
  std::optional<double> opacity;     ///< replaces the model's alpha
  Material material;

  bool operator==(const MaterialRule&) const = default;
};

struct Camera {
  std::optional<glm::dvec3> eye;
  std::optional<glm::dvec3> centre;
  std::optional<bool> is_perspective;
  std::optional<bool> view_all;
  std::optional<double> near;  ///< distance of the near plane, in model units

  bool operator==(const Camera&) const = default;
};

struct Background {
  std::optional<glm::dvec3> colour;

  bool operator==(const Background&) const = default;
};

/// Colours of faces to which neither the model nor a material assigns a colour; the defaults are in host/lighting.
struct Uncoloured {
  std::optional<glm::dvec3> face;
  std::optional<glm::dvec3> cut_face;  ///< surface where a solid was subtracted

  bool operator==(const Uncoloured&) const = default;
};

/// An effect that appears in the scene.
struct EffectRequest {
  std::string_view name;  ///< name of the effect's section
  /// The section's table, or all tables of a list section; the effect parses its settings from them.
  std::vector<Values> tables;
  bool is_on = true;  ///< if false, the effect is off even if the model requests it
};

struct Scene {
  Camera camera;
  Background background;
  Uncoloured uncoloured;
  Ambient ambient;
  std::vector<Light> lights;            ///< if empty, the default light is used (host/lighting)
  std::vector<MaterialRule> materials;  ///< ordered; later rules win
  std::vector<EffectRequest> effects;   ///< in the order of the effects' sections
};

}  // namespace csgsim::scene
