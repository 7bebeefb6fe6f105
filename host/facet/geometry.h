// A model as half-spaces and quadrics, with bounding boxes.
// Used by host/convex, host/csg, host/effects, host/emit, host/read, host/setup, host/solids, host/view and sim.
#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/planes.h"
#include "host/facet/quadric_table.h"
#include "host/facet/solid.h"
#include "host/model/tree.h"

namespace csgsim::facet {

/// An axis-aligned box; empty if any component of `low` exceeds that of `high`.
struct Box {
  glm::dvec3 low{1};
  glm::dvec3 high{0};

  [[nodiscard]] bool empty() const { return low.x > high.x || low.y > high.y || low.z > high.z; }
  [[nodiscard]] glm::dvec3 centre() const { return low + (high - low) / 2.0; }
  [[nodiscard]] double diagonal() const { return glm::length(high - low); }
  bool operator==(const Box&) const = default;
};

Box hull(const Box& a, const Box& b);
Box hull(const Box& box, const glm::dvec3& point);
Box common(const Box& a, const Box& b);
Box box_of(std::span<const glm::dvec3> points);

/// A primitive as an intersection of canonical half-spaces and, if it is curved, a quadric.
struct Convex {
  std::vector<Halfspace> halfspaces;  ///< in the order of the faces, without duplicates
  std::vector<glm::dvec3> vertices;   ///< model space; for a curved solid, those of a polytope that contains it
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< pairs of vertices, each edge once
  Box box;                                          ///< bounds of the vertices; for a curved solid, its own bounds
  std::vector<QuadricSide> quadrics;
};

/// A model prepared for any view.
struct Geometry {
  std::vector<Convex> solids;  ///< one per primitive of the tree
  PlaneTable planes;
  Box box;  ///< contains the result of the tree
  QuadricTable quadrics{};
  /// Whether the quadrics are spheres to be drawn as fast spheres (host/view/fast_sphere.h).
  bool fast_spheres = false;

  /// Total number of half-spaces of all primitives. Shared planes count once for each primitive; a quadric counts as
  /// one.
  [[nodiscard]] std::uint64_t halfspaces() const;
  /// Whether no primitive stays curved.
  [[nodiscard]] bool is_faceted() const;
};

/// Facets every primitive that does not stay curved. Throws InputError, with the primitive's position in the file, if
/// one cannot be faceted.
Geometry make_geometry(const model::Tree& tree, const Faceting& faceting = {});

/// Folds the boxes of the primitives over the tree: unions span, intersections clip, differences keep their first
/// operand.
Box fold_boxes(const model::Tree& tree, const std::vector<Box>& boxes);

}  // namespace csgsim::facet
