#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "host/swept/element.h"

namespace csgsim::swept {

/// Who takes a mesh as it becomes ready. Vertices and elements come in no order.
class Output {
 public:
  Output() = default;
  virtual ~Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// The number of a vertex that is yet to come.
  virtual std::uint32_t new_vertex() = 0;
  /// Where it is; once.
  virtual void vertex(std::uint32_t number, const glm::dvec3& point) = 0;
  /// An element: numbers of its vertices from its south-west corner on by south-east, north-east and north-west, with
  /// all that are on its sides.
  virtual void element(const Square& square, std::span<const std::uint32_t> corners) = 0;
};

/// What repairing a mesh did.
struct RepairCounts {
  std::uint64_t elements = 0;
  std::uint64_t vertices = 0;       ///< those of the mesh, each once
  std::uint64_t most_elements = 0;  ///< held at the same time, after an element has been taken in
  std::uint64_t most_vertices = 0;  ///< the same
  std::uint64_t most_edges = 0;     ///< the same; of a tree of nodes, these
  std::uint64_t edges_visited = 0;  ///< of edge lists; nodes of a tree
  std::uint64_t splits = 0;         ///< of edges
  std::uint64_t merges = 0;         ///< edges that went into another
  std::uint64_t snaps = 0;          ///< vertices that were put on a line
};

}  // namespace csgsim::swept
