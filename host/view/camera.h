#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "host/facet/scene.h"

namespace csgsim::view {

enum class Projection : std::uint8_t { orthographic, perspective };

/// A camera as OpenSCAD's: up is +z, the vertical field of view 22.5 degrees; the orthographic picture shows the height
/// 2 |eye - centre| tan(11.25 degrees).
struct Camera {
  glm::dvec3 eye{0, 0, 1};
  glm::dvec3 centre{0};
  Projection projection = Projection::orthographic;
};

/// The picture's right, up and forward directions in model space; orthonormal.
struct Basis {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 forward;
};

/// Throws InputError if eye and centre coincide or are not finite. Looking straight up or down, right is +x.
Basis basis(const Camera& camera);

/// Half the vertical field of view's tangent.
double half_height_per_distance();

/// Model units that half the height of an orthographic picture shows.
double half_height(const Camera& camera);

/// Model units that a pixel of a picture so many pixels high covers at a distance along the view axis.
double pixel_size(const Camera& camera, std::uint32_t height, double distance);

/// The camera that looks from the same direction at the middle of the box, from where its bounding sphere just fits
/// into a picture of that many pixels.
Camera view_all(const Camera& camera, const facet::Box& box, std::uint32_t width, std::uint32_t height);

/// OpenSCAD's default direction of view, from the front right and above, with the whole box in the picture.
Camera default_camera(const facet::Box& box, std::uint32_t width, std::uint32_t height);

}  // namespace csgsim::view
