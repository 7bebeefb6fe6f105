// Swept solids defined by four design curves.
// Used by mesh.h, spine.h and host/commands.
#pragma once

#include <memory>
#include <string>

#include "host/swept/curve.h"
#include "host/swept/surface.h"

namespace csgsim::swept {

/// A solid defined by the four design curves of the thesis (3.2): a contour in u (x) and v (y) moves along a
/// trajectory, perpendicular to its tangent, and is scaled and rotated in its plane.
struct Sweep {
  Curve contour;     ///< closed; degree 1 to 3
  Curve trajectory;  ///< degree 1 to 3
  /// X: degrees from u to v, as a function of the fraction of the trajectory's length.
  Curve rotation{0, false, {{0, 0, 0}}};
  /// X: factor along u; y: factor along v; both at least 0, as functions of the fraction of the trajectory's length.
  Curve scale{0, false, {{1, 1, 0}}};
};

/// The first error in a sweep that is detectable before its surface is built, and how to fix it; empty if there is
/// none.
std::string validation_error(const Sweep& sweep);

/// Twice the signed area of a contour's control polygon; positive if counter-clockwise.
double twice_signed_area(const Curve& contour);

/// The swept surface: one column per segment of the contour, one row per segment of the trajectory. Throws InputError
/// as Spine does.
std::unique_ptr<Surface> make_surface(const Sweep& sweep);

}  // namespace csgsim::swept
