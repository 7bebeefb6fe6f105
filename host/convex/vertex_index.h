// Spatial index of a polytope's vertices.
// Used by carver.h.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/facet/geometry.h"
#include "host/facet/solid.h"

namespace csgsim::convex {

/// Vertices in a tree of cells, each halved across its longest side, for queries of the vertices in front of a plane.
class VertexIndex {
 public:
  /// Vertices outside the box are found too, but more slowly.
  explicit VertexIndex(const facet::Box& box);

  /// `normal` is that of a face at the vertex, or 0; queries are fastest for planes close to that face.
  void insert(std::uint32_t vertex, const glm::dvec3& position, const glm::dvec3& normal);
  /// Removes an existing vertex, given its position.
  void remove(std::uint32_t vertex, const glm::dvec3& position);

  /// Appends the vertices whose Plane::height() is not below -near to `found`, exactly and in no particular order.
  /// Returns the number of vertices visited.
  std::uint64_t find(const facet::Plane& plane, double tolerance, std::vector<std::uint32_t>& found) const;

 private:
  struct IndexedVertex {
    std::uint32_t vertex = 0;
    glm::dvec3 place{};
    glm::dvec3 normal{};
  };
  struct Cell {
    facet::Box whole;         ///< region that is halved
    facet::Box box;           ///< contains all vertices added since the cell was last empty
    glm::dvec3 normal{};      ///< normal of the first of these vertices
    double highest = 0;       ///< maximum of normal . place over these vertices
    std::uint32_t count = 0;  ///< number of vertices
    std::uint32_t below = 0;  ///< index of the lower half, which the upper half follows; 0 if the cell is not divided
    unsigned depth = 0;
    int axis = 0;                     ///< axis across which the cell is divided
    std::vector<IndexedVertex> held;  ///< vertices, if the cell is not divided

    [[nodiscard]] double middle() const { return whole.low[axis] + (whole.high[axis] - whole.low[axis]) / 2.0; }
    /// The half that contains a position.
    [[nodiscard]] std::uint32_t half_at(const glm::dvec3& position) const {
      return below + (position[axis] < middle() ? 0U : 1U);
    }
    void put(const IndexedVertex& entry);
    /// Whether every vertex is certainly less than `height` above the plane, despite rounding errors.
    [[nodiscard]] bool is_surely_below(const facet::Plane& plane, double height) const;
  };

  void divide(std::uint32_t cell);

  std::vector<Cell> cells_;
};

}  // namespace csgsim::convex
