#pragma once

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <vector>

#include "host/convex/cutter.h"
#include "host/convex/polytope.h"
#include "host/convex/vertex_index.h"
#include "host/facet/planes.h"

namespace csgsim::convex {

/// Clips one polytope by one half-space after another, as clip() does, to the same bits, but without a look at the
/// vertices and faces that a plane is far from. Each cut goes over all corners of the faces that it meets: solids whose
/// faces all share a corner, or a face, still take the square of their half-spaces. Keeps references.
class Carver {
 public:
  Carver(Polytope polytope, const facet::PlaneTable& planes);

  void clip(facet::Halfspace halfspace);
  [[nodiscard]] bool empty() const { return faces_ == 0; }
  /// Steps of work (hw/base/work.h) that the last clip() took, about.
  [[nodiscard]] std::uint64_t steps() const;
  /// What is left. Nothing can be clipped after that.
  Polytope take();

 private:
  /// Whether a vertex is farther in than that.
  bool has_depth(const facet::Plane& plane, double near);
  /// Finds the vertices that are not in, and notes their sides. Returns whether one is out.
  bool find_sides(const facet::Plane& plane, double near);
  /// The faces at the vertices that were found, ascending.
  std::vector<std::uint32_t> faces_found();
  void apply(Cut made, facet::Halfspace halfspace);
  /// On a face with that normal.
  void add_vertex(const glm::dvec3& place, const glm::dvec3& normal);
  /// Takes out vertices that only two faces are left at, whose edges there become one, and faces without area.
  void drop_flat(std::vector<std::uint32_t> doubtful);
  void drop_vertex(std::uint32_t vertex);
  /// Takes out a face, whose corners are doubtful then.
  void drop_face(std::uint32_t face, std::vector<std::uint32_t>& doubtful);
  void clear();

  using FacesAt = boost::container::small_vector<std::uint32_t, 4>;

  const facet::PlaneTable& planes_;
  Polytope polytope_;  ///< with vertices that no face has, and faces without corners
  std::uint32_t faces_ = 0;
  std::vector<FacesAt> at_;        ///< of each vertex the faces that have it
  std::vector<bool> is_alive_;     ///< of each vertex, whether a face has it
  std::vector<VertexSide> sides_;  ///< of the half-space; in, but of those found
  VertexIndex index_;
  std::vector<std::uint32_t> found_;
  std::uint32_t deep_ = 0;         ///< a vertex that was in last
  std::uint32_t first_alive_ = 0;  ///< no vertex before it is
  std::uint64_t looked_at_ = 0;
};

}  // namespace csgsim::convex
