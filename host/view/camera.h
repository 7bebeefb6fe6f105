// Cameras as in OpenSCAD, and the axes of their views.
// Used by host/effects, host/lighting, host/setup, sim/judges, sim/session and sim/studies.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "host/facet/geometry.h"

namespace csgsim::view {

enum class Projection : std::uint8_t { orthographic, perspective };

/// A camera as in OpenSCAD, with a vertical field of view of 22.5 degrees. An orthographic picture shows the height 2
/// |eye - centre| tan(11.25 degrees).
struct Camera {
  glm::dvec3 eye{0, 0, 1};
  glm::dvec3 centre{0};
  Projection projection = Projection::orthographic;
  /// Upward direction in the picture; only its component perpendicular to the view direction matters.
  glm::dvec3 up{0, 0, 1};
};

/// OpenSCAD's camera of seven numbers: it looks at `centre` from above, with +y up, at `distance`, and is then rotated
/// by `degrees` about x, y and z in that order.
Camera gimbal_camera(const glm::dvec3& centre, const glm::dvec3& degrees, double distance);

/// The camera rotated counterclockwise about the vertical axis through its centre.
Camera turned(const Camera& camera, double radians);

/// The right, up and forward directions of the picture in model space; orthonormal.
struct Basis {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 forward;
};

/// The basis of a camera. Throws InputError if eye and centre coincide or are not finite. If the view is along `up`, +y
/// is up instead.
Basis basis(const Camera& camera);

/// Tangent of half the vertical field of view.
double half_height_per_distance();

/// Half the height of an orthographic picture, model units.
double half_height(const Camera& camera);

/// Size of a pixel at a distance along the view axis, in model units, in a picture that is `height` pixels high.
double pixel_size(const Camera& camera, std::uint32_t height, double distance);

/// A camera with the same direction that looks at the centre of the box, from the distance at which its bounding sphere
/// just fits into a picture of `width` x `height` pixels.
Camera view_all(const Camera& camera, const facet::Box& box, std::uint32_t width, std::uint32_t height);

/// OpenSCAD's default view direction, from the front right and above, with the whole box in the picture.
Camera default_camera(const facet::Box& box, std::uint32_t width, std::uint32_t height);

}  // namespace csgsim::view
