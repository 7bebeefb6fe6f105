// Fast spheres: spheres drawn as paraboloids by linear-expression hardware.
// Used by host/emit.
#pragma once

#include "host/facet/quadric_table.h"
#include "host/view/eye_space.h"
#include "host/view/projection.h"
#include "host/view/screen_quadric.h"

namespace csgsim::view {

/// A canonical sphere in an orthographic picture, drawn as hardware for linear expressions can draw it (Fuchs,
/// Goldfeather, Hultquist et al. 1985). A pixel at distance d from the centre is inside if r^2 - d^2 is not negative.
/// This is linear in x and y, except for x^2 + y^2, which is kept in pixel memory. The sphere's depths are replaced by
/// those of a paraboloid, c -/+ k (r^2 - d^2). Its discriminant is r^2 - d^2, in square pixels.
///
/// A paraboloid that touches the sphere at the front and at the outline has k = R / r^2, where R is the radius in depth
/// steps. Here k is the greatest sum or difference of two powers of two for which the paraboloid, including floors,
/// stays inside the sphere: k r^2 is p R with p from 5/6 to 1, within a few depth steps. At the fraction u = sqrt(1 -
/// d^2 / r^2) of the half depth R, the surfaces are R (u - p u^2) apart: at most R / (4 p), which is 0.3 of the radius,
/// or 0.25 for p = 1.
///
/// The outline is off by at most 1 / 256 of a pixel if r is at least a third of a pixel. The result is `unfit` in
/// perspective, where a sphere appears as an ellipse, and if the integers do not fit the machine. Parameters as for
/// make_screen_quadric().
ScreenQuadric make_fast_sphere(const EyeSpace& space, const View& view, const facet::Quadric& quadric,
                               const glm::dvec3& centre, const PixelRect& pixels);

/// The unrounded depth of a paraboloid at a point of the picture: the nearer depth if `is_near`, otherwise the farther
/// one.
double paraboloid_depth(const ScreenQuadric& quadric, const Sampling& sampling, double x, double y, bool is_near);

}  // namespace csgsim::view
