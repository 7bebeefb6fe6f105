// Repeated clipping of one polytope with an index of its vertices.
// Used by polytope.cpp.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <vector>

#include "host/convex/cutter.h"
#include "host/convex/polytope.h"
#include "host/convex/vertex_index.h"
#include "host/facet/planes.h"

namespace csgsim::convex {

/// Clips one polytope by a sequence of half-spaces. Results are bit-identical to those of clip(), but vertices and
/// faces far from a plane are not visited. A cut visits all corners of the faces that it meets, so solids whose faces
/// all share a corner or a face still take time quadratic in their half-spaces. Keeps a reference to `planes`.
class Carver {
 public:
  Carver(Polytope polytope, const facet::PlaneTable& planes);

  void clip(facet::Halfspace halfspace);
  [[nodiscard]] bool empty() const { return faces_ == 0; }
  /// Approximate cost of the last clip(), in steps of work (hw/base/work.h).
  [[nodiscard]] std::uint64_t steps() const;
  /// Returns the remaining polytope; the Carver cannot be used afterwards.
  Polytope take();

 private:
  /// Whether some vertex is more than `tolerance` behind the plane.
  bool has_vertex_behind(const facet::Plane& plane, double tolerance);
  /// Finds the vertices that are not inside, and stores their sides. Returns whether any vertex is outside.
  bool find_sides(const facet::Plane& plane, double tolerance);
  /// The faces at the found vertices, in ascending order.
  std::vector<std::uint32_t> faces_at_found_vertices();
  void apply_cut(Cut cut, facet::Halfspace halfspace);
  /// Adds a vertex on a face whose normal is `normal`.
  void add_vertex(const glm::dvec3& position, const glm::dvec3& normal);
  /// Removes vertices with only two faces left, which merges their edges there, and faces without area.
  void remove_flat_parts(std::vector<std::uint32_t> doubtful);
  void drop_vertex(std::uint32_t vertex);
  /// Removes a face; its corners become doubtful.
  void drop_face(std::uint32_t face, std::vector<std::uint32_t>& doubtful);
  void clear();

  using FacesAt = boost::container::small_vector<std::uint32_t, 4>;

  const facet::PlaneTable& planes_;
  Polytope polytope_;  ///< also contains vertices without faces, and faces without corners
  std::uint32_t faces_ = 0;
  std::vector<FacesAt> at_;        ///< faces at each vertex
  std::vector<bool> is_alive_;     ///< whether a face uses the vertex
  std::vector<VertexSide> sides_;  ///< sides relative to the half-space; `in` except for found vertices
  VertexIndex index_;
  std::vector<std::uint32_t> found_;
  std::uint32_t deep_ = 0;         ///< the last vertex known to be inside
  std::uint32_t first_alive_ = 0;  ///< no vertex before this one is alive
  std::uint64_t visited_ = 0;
};

}  // namespace csgsim::convex
