// Primitives as exact convex solids.
// Used by mesh and block conversion.
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
  UnitBox box;                   ///< bounding box; empty if the face has no area
  double radius = 0;             ///< radius of a bounding ball about the box's centre
  std::uint32_t first_side = 0;  ///< index into Body::sides
  std::uint32_t sides = 0;
};

inline constexpr std::uint32_t no_vertex = 0xffffffffU;

/// A side of a face: the plane along it, and the vertex of the solid that its first corner represents, or no_vertex.
struct BodySide {
  std::uint32_t plane = 0;
  std::uint32_t vertex = no_vertex;
};

/// A face of the original solid, in rounded arithmetic; the body may have it in two parts.
struct BodyPolygon {
  std::uint32_t face = 0;
  std::uint32_t first_corner = 0;  ///< index into Body::corners
  std::uint32_t corners = 0;
};

/// A primitive as a convex solid: the exact intersection of its half-spaces.
struct Body {
  std::vector<BodyFace> faces;
  std::vector<BodySide> sides;       ///< by face, counter-clockwise as seen from the tip of the plane's normal
  UnitBox box;                       ///< bounding box; empty if the body has no volume
  glm::dvec3 middle{0};              ///< mean of its vertices, in units
  double outer = 0;                  ///< radius of a bounding ball about `middle`
  double inner = 0;                  ///< radius of an inscribed ball about `middle`; negative if there is none
  std::vector<glm::dvec3> vertices;  ///< in model space, in rounded arithmetic
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< pairs of vertices; empty if there are more than most_edges
  std::vector<BodyPolygon> polygons;                ///< empty if the corners of a face are unknown
  std::vector<std::uint32_t> corners;               ///< vertices, counter-clockwise as seen from outside

  static constexpr std::size_t most_edges = 200;

  [[nodiscard]] std::span<const BodySide> sides_of(const BodyFace& face) const {
    return std::span(sides).subspan(face.first_side, face.sides);
  }
  [[nodiscard]] std::span<const std::uint32_t> corners_of(const BodyPolygon& polygon) const {
    return std::span(corners).subspan(polygon.first_corner, polygon.corners);
  }
};

/// The faceted primitives of a model.
struct Bodies {
  glm::dvec3 reference{0};          ///< in model space; origin of positions in units
  double tolerance = 0;             ///< points closer to each other than this may be merged; model units
  std::vector<facet::Plane> faces;  ///< planes of faces, relative to `reference`, in model units
  WholePlanes planes;
  std::vector<Body> bodies;  ///< one per primitive
  csg::BoxIndex index;       ///< index of the bodies' boxes

  /// Bodies whose boxes intersect this box, ascending.
  [[nodiscard]] std::vector<std::uint32_t> bodies_meeting(const UnitBox& box) const;
};

/// Throws InputError, with the primitive's place in the file, if it cannot be faceted, and WorkError beyond the work
/// limit.
Bodies make_bodies(const model::Tree& tree, const facet::Faceting& faceting, const Work& work = {});

}  // namespace csgsim::software::convert
