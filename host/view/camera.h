#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "host/facet/geometry.h"

namespace csgsim::view {

enum class Projection : std::uint8_t { orthographic, perspective };

/// A camera as OpenSCAD's: the vertical field of view 22.5 degrees; the orthographic picture shows the height
/// 2 |eye - centre| tan(11.25 degrees).
struct Camera {
  glm::dvec3 eye{0, 0, 1};
  glm::dvec3 centre{0};
  Projection projection = Projection::orthographic;
  glm::dvec3 up{0, 0, 1};  ///< in the picture, as far as it is across the view
};

/// OpenSCAD's camera of seven numbers: it looks at a point from above, with +y upwards, and is then turned by the given
/// degrees about x, y and z in that order.
Camera gimbal_camera(const glm::dvec3& centre, const glm::dvec3& degrees, double distance);

/// The camera turned counterclockwise about the vertical axis through its centre.
Camera turned(const Camera& camera, double radians);

/// The picture's right, up and forward directions in model space; orthonormal.
struct Basis {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 forward;
};

/// Throws InputError if eye and centre coincide or are not finite. Looking along `up`, +y is up.
Basis basis(const Camera& camera);

/// Half the vertical field of view's tangent.
double half_height_per_distance();

/// Model units that half the height of an orthographic picture shows.
double half_height(const Camera& camera);

/// Model units that a pixel covers, at a distance along the view axis, in a picture that many pixels high.
double pixel_size(const Camera& camera, std::uint32_t height, double distance);

/// The camera that looks from the same direction at the middle of the box, from where its bounding sphere just fits
/// into a picture of that many pixels.
Camera view_all(const Camera& camera, const facet::Box& box, std::uint32_t width, std::uint32_t height);

/// OpenSCAD's default direction of view, from the front right and above, with the whole box in the picture.
Camera default_camera(const facet::Box& box, std::uint32_t width, std::uint32_t height);

}  // namespace csgsim::view
