#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/csg/box_index.h"
#include "host/facet/faceting.h"
#include "host/facet/planes.h"
#include "host/model/tree.h"
#include "hw/base/work.h"
#include "sim/software/planes/sheet.h"
#include "sim/software/planes/unit_box.h"
#include "sim/software/planes/whole_planes.h"

namespace csgsim::software::convert {

/// A face of a body, in the plane of a half-space.
struct BodyFace {
  facet::Halfspace halfspace;
  UnitBox box;                   ///< holds it; empty if the face has no area
  double radius = 0;             ///< of a ball about the middle of the box that holds it
  std::uint32_t first_side = 0;  ///< of Body::sides
  std::uint32_t sides = 0;
};

inline constexpr std::uint32_t no_vertex = 0xffffffffU;

/// A side of a face: the plane along it, and the solid's vertex that its first corner stands for, or no_vertex.
struct BodySide {
  std::uint32_t plane = 0;
  std::uint32_t vertex = no_vertex;
};

/// A face of the solid that a body was made of, as rounded numbers tell it; the body may have it in two parts.
struct BodyPolygon {
  std::uint32_t face = 0;
  std::uint32_t first_corner = 0;  ///< of Body::corners
  std::uint32_t corners = 0;
};

/// A primitive as a convex solid: exactly what all of its half-spaces have in common.
struct Body {
  std::vector<BodyFace> faces;
  std::vector<BodySide> sides;       ///< by face, counter-clockwise as seen from where the plane's normal points to
  UnitBox box;                       ///< holds it; empty if the body has no volume
  glm::dvec3 middle{0};              ///< of its vertices, in units
  double outer = 0;                  ///< radius of a ball about that which holds it
  double inner = 0;                  ///< and of one that it holds; below 0 if it holds none
  std::vector<glm::dvec3> vertices;  ///< in model space, as rounded numbers tell them
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< between these; none if there are more than most_edges
  std::vector<BodyPolygon> polygons;                ///< none if the corners of a face are not known
  std::vector<std::uint32_t> corners;               ///< vertices, counter-clockwise as seen from outside

  static constexpr std::size_t most_edges = 200;

  [[nodiscard]] std::span<const BodySide> sides_of(const BodyFace& face) const {
    return std::span(sides).subspan(face.first_side, face.sides);
  }
  [[nodiscard]] std::span<const std::uint32_t> corners_of(const BodyPolygon& polygon) const {
    return std::span(corners).subspan(polygon.first_corner, polygon.corners);
  }
};

/// The primitives of a model, faceted.
struct Bodies {
  glm::dvec3 reference{0};          ///< in model space; places in units are relative to it
  double tolerance = 0;             ///< points that are nearer to each other than this may become one; model units
  std::vector<facet::Plane> faces;  ///< the planes of faces, relative to `reference`, in model units
  WholePlanes planes;
  std::vector<Body> bodies;  ///< one a primitive
  csg::BoxIndex index;       ///< of the bodies' boxes

  /// Bodies whose boxes have a point in common with that one, ascending.
  [[nodiscard]] std::vector<std::uint32_t> meeting(const UnitBox& box) const;
};

/// Throws InputError, naming the primitive's place in the file, where one cannot be faceted, and WorkError past the
/// limit on work.
Bodies make_bodies(const model::Tree& tree, const facet::Faceting& faceting, const Work& work = {});

}  // namespace csgsim::software::convert
