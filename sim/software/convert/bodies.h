#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/csg/box_index.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "sim/software/planes/unit_box.h"
#include "sim/software/planes/whole_planes.h"

namespace csgsim::software::convert {

/// A face of a body, in the plane of a half-space.
struct BodyFace {
  facet::Halfspace halfspace;
  std::vector<std::uint32_t> neighbours;  ///< faces that share a corner with it; none if that is not known
  UnitBox box;                            ///< holds it
  std::uint32_t first_polygon = 0;        ///< of Body::polygons
  std::uint32_t polygons = 0;             ///< how many; 0 if its corners are not known
};

/// Of a ball and a convex body.
enum class BallIs : std::uint8_t { inside, outside, neither };

/// Corners of a face, vertices of the solid (facet::Convex), that run counter-clockwise as seen from outside.
struct BodyPolygon {
  std::uint32_t face = 0;
  std::vector<std::uint32_t> corners;
};

/// A primitive as a convex solid.
struct Body {
  std::vector<BodyFace> faces;
  /// By their faces; several of a face whose half-space is several planes'. None if not all are known.
  std::vector<BodyPolygon> polygons;
  UnitBox box;
  glm::dvec3 middle{0};  ///< of its vertices, in units
  double outer = 0;      ///< radius of a ball about that which holds it
  double inner = 0;      ///< and of one that it holds; below 0 if it holds none
};

/// The primitives of a model, faceted.
struct Bodies {
  facet::Geometry geometry;
  WholePlanes planes;
  std::vector<Body> bodies;  ///< one a primitive
  csg::BoxIndex index;       ///< of the bodies' boxes

  /// As rounded numbers tell it; neither is said at times of a ball that is outside. The plane `but` is left out.
  [[nodiscard]] BallIs ball_is(const Body& body, const glm::dvec3& middle, double radius, std::uint32_t but) const;

  /// Bodies whose boxes have a point in common with that one, ascending.
  [[nodiscard]] std::vector<std::uint32_t> meeting(const UnitBox& box) const;
};

/// By which boxes are wider than what they hold: more than corners are off where planes meet at small angles.
inline constexpr double box_margin = 1e-9;

/// Which half-spaces of a body are held against a face of it.
enum class Neighbours : std::uint8_t {
  corner,  ///< those of faces that share a corner with it: no others reach it, unless it is as small as rounding errs
  all,     ///< and no polygons are told
};

/// Throws InputError, naming the primitive's place in the file, where one cannot be faceted.
Bodies make_bodies(const model::Tree& tree, const facet::Faceting& faceting,
                   Neighbours neighbours = Neighbours::corner);

}  // namespace csgsim::software::convert
