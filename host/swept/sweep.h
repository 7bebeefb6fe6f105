#pragma once

#include <memory>
#include <string>

#include "host/swept/curve.h"
#include "host/swept/surface.h"

namespace csgsim::swept {

/// A solid by the four design curves of the thesis (3.2): a contour, in u (x) and v (y), is moved along a trajectory,
/// orthogonal to its tangent, and scaled and turned within its plane.
struct Sweep {
  Curve contour;                          ///< closed, of degree 1 to 3
  Curve trajectory;                       ///< of degree 1 to 3
  Curve rotation{0, false, {{0, 0, 0}}};  ///< x: degrees, from u to v; over the part of the trajectory's length
  Curve scale{0, false, {{1, 1, 0}}};     ///< x: along u, y: along v; not below 0; over the same
};

/// What is wrong with a sweep, and what to do; empty if nothing is that is known before its surface is.
std::string fault_of(const Sweep& sweep);

/// Twice the area that the control points of a contour go around: above 0 counter-clockwise.
double turn_of(const Curve& contour);

/// The swept surface: a column for each segment of the contour, a row for each of the trajectory. Throws InputError as
/// Spine does.
std::unique_ptr<Surface> surface_of(const Sweep& sweep);

}  // namespace csgsim::swept
