#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/csg/box_index.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "sim/software/convert/unit_box.h"
#include "sim/software/convert/whole_planes.h"

namespace csgsim::software::convert {

/// A face of a body, in the plane of a half-space.
struct BodyFace {
  facet::Halfspace halfspace;
  std::vector<std::uint32_t> neighbours;  ///< faces that share a corner with it; none if that is not known
  UnitBox box;                            ///< holds it
};

/// Corners of a face, vertices of the solid (facet::Convex), that run counter-clockwise as seen from outside.
struct BodyPolygon {
  std::uint32_t face = 0;
  std::vector<std::uint32_t> corners;
};

/// A primitive as a convex solid.
struct Body {
  std::vector<BodyFace> faces;
  std::vector<BodyPolygon>
      polygons;  ///< several of a face whose half-space is several planes'; none if not all are known
  UnitBox box;
};

/// The primitives of a model, faceted.
struct Bodies {
  facet::Geometry geometry;
  WholePlanes planes;
  std::vector<Body> bodies;  ///< one a primitive
  csg::BoxIndex index;       ///< of the bodies' boxes

  /// Bodies whose boxes have a point in common with that one, ascending.
  [[nodiscard]] std::vector<std::uint32_t> meeting(const UnitBox& box) const;
};

/// Which half-spaces of a body are held against a face of it.
enum class Neighbours : std::uint8_t {
  corner,  ///< those of faces that share a corner with it: no others reach it, unless it is as small as rounding errs
  all,
};

/// Throws InputError, naming the primitive's place in the file, where one cannot be faceted.
Bodies make_bodies(const model::Tree& tree, const facet::Faceting& faceting,
                   Neighbours neighbours = Neighbours::corner);

}  // namespace csgsim::software::convert
