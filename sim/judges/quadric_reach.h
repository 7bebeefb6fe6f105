#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "sim/judges/exact_camera.h"
#include "sim/judges/quadric_sight.h"

namespace csgsim::judges {

/// Places of a picture, [x0, x1] x [y0, y1].
struct PlaceRect {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;
};

/// The places of the picture that the solids of each canonical quadric can touch, by their corners and where the near
/// plane cuts their edges, with two pixels around them.
std::vector<PlaceRect> quadric_reaches(const facet::Geometry& geometry, const ExactCamera& camera);

/// The places that each solid's vertices take, and where the near plane cuts its edges: least and greatest. None if it
/// is before the near plane.
std::vector<PlaceRect> solid_reaches(const facet::Geometry& geometry, const ExactCamera& camera);

/// The greatest and least value over a rectangle of places; 0 if that is empty.
double greatest(const FilterQuadratic& of, const PlaceRect& over);
double least(const FilterQuadratic& of, const PlaceRect& over);

/// The most pixels that a cone whose apex is near the eye moves sideways in the picture, at its corners, for each unit
/// of depth q (Sight).
double apex_shift(const facet::QuadricTable& quadrics, std::uint32_t index, const ExactCamera& camera);

}  // namespace csgsim::judges
