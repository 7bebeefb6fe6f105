// Interface that receives repaired meshes, and counts of the repair. Used throughout host/swept.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "host/swept/element.h"

namespace csgsim::swept {

/// Receives a mesh while it is generated. Vertices and elements arrive in no particular order.
class Output {
 public:
  Output() = default;
  virtual ~Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Allocates the number of a vertex whose position is set later.
  virtual std::uint32_t new_vertex() = 0;
  /// Sets the position of a vertex; called once.
  virtual void vertex(std::uint32_t number, const glm::dvec3& point) = 0;
  /// Adds an element with the numbers of its vertices, counter-clockwise from its south-west corner, including all
  /// vertices on its sides.
  virtual void element(const Square& square, std::span<const std::uint32_t> corners) = 0;
};

/// Counts of a mesh repair.
struct RepairCounts {
  std::uint64_t elements = 0;
  std::uint64_t vertices = 0;       ///< distinct vertices of the mesh
  std::uint64_t most_elements = 0;  ///< peak number of elements held, measured after each element
  std::uint64_t most_vertices = 0;  ///< peak number of vertices held
  std::uint64_t most_edges = 0;     ///< peak number of edges held; for a quadtree, of its nodes
  std::uint64_t edges_visited = 0;  ///< number of list edges visited; for a quadtree, of nodes
  std::uint64_t splits = 0;         ///< number of edges split
  std::uint64_t merges = 0;         ///< number of edges merged into another edge
  std::uint64_t snaps = 0;          ///< number of vertices placed on a line
};

}  // namespace csgsim::swept
