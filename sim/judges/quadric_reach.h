// Rectangles of the picture that quadrics and solids can touch.
// Used by the explainer and the quadric bounds.
#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "sim/judges/exact_camera.h"
#include "sim/judges/quadric_sight.h"

namespace csgsim::judges {

/// The places [x0, x1] x [y0, y1] of a picture.
struct PlaceRect {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;
};

/// The places that the solids of each canonical quadric can touch, from their corners and the near plane's cuts of
/// their edges, with a margin of two pixels.
std::vector<PlaceRect> quadric_reaches(const facet::Geometry& geometry, const ExactCamera& camera);

/// The bounding rectangle of each solid's vertices and of the near plane's cuts of its edges. Empty if the solid is in
/// front of the near plane.
std::vector<PlaceRect> solid_reaches(const facet::Geometry& geometry, const ExactCamera& camera);

/// Maximum and minimum of a quadratic over a rectangle of places, without its error; 0 if the rectangle is empty.
double maximum(const FilterQuadratic& quadratic, const PlaceRect& rectangle);
double minimum(const FilterQuadratic& quadratic, const PlaceRect& rectangle);

/// Maximum sideways shift, in pixels per unit of depth q (sight.h), of the section of a cone whose apex is near the
/// eye. The maximum is over the picture's corners.
double apex_shift(const facet::QuadricTable& quadrics, std::uint32_t index, const ExactCamera& camera);

}  // namespace csgsim::judges
