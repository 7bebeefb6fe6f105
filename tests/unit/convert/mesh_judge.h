#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::testing {

/// Faces with three or more corners, as indices of points.
struct JudgedMesh {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// Describes the first fault of a mesh as the boundary of a solid; empty if each side of a face is shared with exactly
/// one other face that runs in the opposite direction, no face has a corner twice, and no point lies on an edge between
/// its ends. Every edge is compared with every point. Sides between coplanar faces are exempt, because a point of
/// another part may touch such a plane anywhere.
std::string fault_of(const JudgedMesh& mesh);

/// Checks only the sides of the faces: each must be shared with exactly one face that runs in the opposite direction.
std::string sides_fault_of(const JudgedMesh& mesh);

/// Same check after merging equal points: equally many sides must run each way.
std::string welded_fault_of(const JudgedMesh& mesh);

/// Volume by the divergence theorem in long double.
double volume_of(const JudgedMesh& mesh);

/// Winding number of the mesh around a point: the sum of the solid angles of its triangles. The point must not be close
/// to a face.
int winding(const JudgedMesh& mesh, const glm::dvec3& point);

/// Number of parts whose faces are connected along sides.
std::size_t part_count(const JudgedMesh& mesh);

}  // namespace csgsim::testing
