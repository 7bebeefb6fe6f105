// Wire frame of the edges between patches.
// Used by filter.h, mesh.h and quadtree.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/swept/output.h"
#include "host/swept/surface.h"

namespace csgsim::swept {

/// A vertex of a patch's edge.
struct WireVertex {
  std::uint32_t place = 0;   ///< position along the edge, from 0 to whole_side
  std::uint32_t number = 0;  ///< vertex number in the mesh
  glm::dvec3 point{0};
  /// Whether it is the end of a segment; otherwise it is inside a segment, where one patch has smaller elements.
  bool is_end = true;
};

/// Vertices in the order of their positions, including both ends.
using WireEdge = std::vector<WireVertex>;

/// The four edges of a patch.
struct PatchEdges {
  const WireEdge* south;
  const WireEdge* west;
  const WireEdge* north;
  const WireEdge* east;
};

/// The edges of all patches. Each segment of an edge is as long as the larger of the two elements that meet there;
/// vertices of smaller elements inside it are placed on its line.
class WireFrame {
 public:
  /// Subdivides each patch once, and adds the vertices to `output`.
  WireFrame(Surface& surface, const Accuracy& accuracy, SubdivisionCounts& counts, Output& output);

  [[nodiscard]] PatchEdges edges(std::size_t column, std::size_t row) const;
  /// The edge below a row, or above the last row.
  [[nodiscard]] const WireEdge& along_u(std::size_t column, std::size_t joint) const;
  /// The edge west of a column, or east of the last column.
  [[nodiscard]] const WireEdge& along_v(std::size_t joint, std::size_t row) const;

  [[nodiscard]] std::uint64_t vertex_count() const { return vertices_; }
  [[nodiscard]] std::uint64_t snaps() const { return snaps_; }

 private:
  struct Mark {
    std::uint32_t place;
    glm::dvec3 point;
  };
  using Marks = std::vector<Mark>;

  [[nodiscard]] std::size_t u_edge(std::size_t column, std::size_t joint) const;
  [[nodiscard]] std::size_t v_edge(std::size_t joint, std::size_t row) const;
  void join(WireEdge& edge, const Marks& first_marks, const Marks& second_marks);
  void number_corners(Output& output);

  std::size_t columns_;
  std::size_t rows_;
  std::size_t u_joints_;  ///< number of parallel edges in a column, from south to north
  std::size_t v_joints_;  ///< number of parallel edges in a row, from west to east
  std::vector<WireEdge> along_u_;
  std::vector<WireEdge> along_v_;
  std::uint64_t vertices_ = 0;
  std::uint64_t snaps_ = 0;
};

}  // namespace csgsim::swept
