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

/// An axis-aligned box; empty if a low is above its high.
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

/// A primitive as an intersection of canonical half-spaces, and of a quadric if it is curved.
struct Convex {
  std::vector<Halfspace> halfspaces;                ///< in the order of the faces, none twice
  std::vector<glm::dvec3> vertices;                 ///< model space; of a curved solid, of a polytope that holds it
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< pairs of vertices, each edge once
  Box box;                                          ///< of the vertices; of a curved solid, its own
  std::vector<QuadricSide> quadrics;
};

/// A model ready for any view.
struct Geometry {
  std::vector<Convex> solids;  ///< one a primitive of the tree
  PlaneTable planes;
  Box box;  ///< holds what the tree leaves of its primitives
  QuadricTable quadrics{};
  bool fast_spheres = false;  ///< the quadrics are spheres, to be drawn as fast spheres (host/view/fast_sphere.h)

  /// Of all primitives, those that share a plane each for itself; a quadric counts as one.
  [[nodiscard]] std::uint64_t halfspaces() const;
  /// Whether no primitive stays curved.
  [[nodiscard]] bool is_faceted() const;
};

/// Facets every primitive that does not stay curved. Throws InputError, naming the primitive's place in the file,
/// where one cannot be faceted.
Geometry make_geometry(const model::Tree& tree, const Faceting& faceting = {});

/// Folds boxes of the primitives over the tree: unions span, intersections clip, differences keep their first operand.
Box fold_boxes(const model::Tree& tree, const std::vector<Box>& boxes);

}  // namespace csgsim::facet
