// Bounded convex polyhedra.
// Used throughout host/convex and by host/solids and sim/software.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/facet/planes.h"
#include "hw/base/work.h"

namespace csgsim::convex {

/// A face of a polytope.
struct Face {
  facet::Halfspace halfspace;          ///< contains the polytope; its plane contains the face
  std::vector<std::uint32_t> corners;  ///< indices into Polytope::vertices, counter-clockwise as seen from outside
};

/// A bounded convex polyhedron. Every edge belongs to exactly two faces, which run along it in opposite directions;
/// every vertex belongs to three or more. Two faces may lie in one plane.
struct Polytope {
  std::vector<glm::dvec3> vertices;  ///< relative to PlaneTable::centre()
  std::vector<Face> faces;           ///< empty if the polytope is empty

  [[nodiscard]] bool empty() const { return faces.empty(); }
};

/// An edge from one vertex to another in the direction of the face `left`; the face `right` runs the other way.
struct Edge {
  std::array<std::uint32_t, 2> vertices{};
  std::uint32_t left = 0;   ///< index into Polytope::faces
  std::uint32_t right = 0;  ///< index into Polytope::faces
};

/// All edges, each once.
std::vector<Edge> edges(const Polytope& polytope);

/// The bounding box, relative to PlaneTable::centre().
facet::Box box_of(const Polytope& polytope);

/// The volume in cubic model units, by the divergence theorem.
double volume(const Polytope& polytope);

/// The intersection of half-spaces, computed by clipping a box. Its faces are in the order of the half-spaces. The box
/// must contain the intersection, and is relative to PlaneTable::centre(). Empty if the result is thinner than the
/// tolerance of clip(). Throws WorkError if the work limit is exceeded.
Polytope intersection(const facet::Box& box, std::span<const facet::Halfspace> halfspaces,
                      const facet::PlaneTable& planes, const Work& work = {});

/// Adds the planes of a box in model space to the table. Returns its six half-spaces.
std::vector<facet::Halfspace> add_box_halfspaces(const facet::Box& box, facet::PlaneTable& planes);

/// A primitive as the intersection of its half-spaces.
Polytope make_polytope(const facet::Convex& solid, const facet::PlaneTable& planes, const Work& work = {});

}  // namespace csgsim::convex
