#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/values.h"

/// What is seen of a model besides its solids: camera, lights, materials, background, effects.
namespace csgsim::scene {

/// Axes that a direction or a place is given in.
enum class Axes : std::uint8_t {
  model,
  camera,  ///< right, up and forward of the eye, which is at 0
};

enum class LightKind : std::uint8_t { directional, point };

struct Light {
  LightKind kind = LightKind::directional;
  Axes axes = Axes::model;
  glm::dvec3 direction{0};  ///< directional: in which it shines; need not have length 1
  glm::dvec3 position{0};   ///< point: model units
  glm::dvec3 colour{1};     ///< red, green, blue, each from 0 to 1
  double intensity = 0.7;   ///< what a surface that faces it gets of its colour

  bool operator==(const Light&) const = default;
};

/// Light that comes from everywhere.
struct Ambient {
  glm::dvec3 colour{1};
  double intensity = 0.3;

  bool operator==(const Ambient&) const = default;
};

/// How a surface throws light back.
struct Material {
  double ambient = 1;     ///< part of the ambient light
  double diffuse = 1;     ///< part of a light that falls on it from the front
  double specular = 0;    ///< part of a light that is mirrored into the eye, in the light's colour
  double shininess = 20;  ///< exponent of the highlight (Blinn): the greater, the smaller it is
  double mirror = 0;      ///< part of what a flat face shows that is its mirror image; 1 is a perfect mirror

  bool operator==(const Material&) const = default;
};

/// Primitives that a scene says something of: those of a colour, those of some lines of the model's file, or, where
/// neither is said, all.
struct Chosen {
  std::optional<glm::dvec3> of_colour;     ///< that the model says
  std::optional<std::uint32_t> from_line;  ///< of the model's file
  std::optional<std::uint32_t> to_line;    ///< inclusive; from_line if not given

  bool operator==(const Chosen&) const = default;
};

/// A material, and the primitives that are of it. The last that holds for a primitive counts.
struct MaterialRule : Chosen {
  std::optional<glm::dvec3> colour;  ///< instead of the model's
  std::optional<double> opacity;     ///< instead of the model's alpha
  Material material;

  bool operator==(const MaterialRule&) const = default;
};

struct Camera {
  std::optional<glm::dvec3> eye;
  std::optional<glm::dvec3> centre;
  std::optional<bool> is_perspective;
  std::optional<bool> view_all;
  std::optional<double> near;  ///< distance of the near plane, model units

  bool operator==(const Camera&) const = default;
};

struct Background {
  std::optional<glm::dvec3> colour;

  bool operator==(const Background&) const = default;
};

/// Faces of solids that neither the model nor a material gives a colour; the usual ones (host/lighting) if not given.
struct Uncoloured {
  std::optional<glm::dvec3> face;
  std::optional<glm::dvec3> cut_face;  ///< where a solid was taken away

  bool operator==(const Uncoloured&) const = default;
};

/// An effect that the scene speaks of.
struct CalledEffect {
  std::string_view name;       ///< of the effect's section
  std::vector<Values> tables;  ///< its own: one, or those of a list; the effect makes its settings of them
  bool is_on = true;           ///< false: not even if the model calls for it
};

struct Scene {
  Camera camera;
  Background background;
  Uncoloured uncoloured;
  Ambient ambient;
  std::vector<Light> lights;            ///< none: the usual one (host/lighting)
  std::vector<MaterialRule> materials;  ///< in order
  std::vector<CalledEffect> effects;    ///< in the order of their rows
};

}  // namespace csgsim::scene
