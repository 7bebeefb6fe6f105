#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::testing {

/// Faces of three or more corners on points.
struct JudgedMesh {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// What is wrong with a mesh that is to be the boundary of a solid; nothing if each side of a face is one of just one
/// other, which runs along it the other way, no face has a corner twice, and no point is on an edge between its ends.
/// Every edge is held against every point; sides between faces of one plane are none, since a point of another part may
/// touch such a plane anywhere.
std::string fault_of(const JudgedMesh& mesh);

/// What is wrong with the sides of the faces alone: each has to be one of just one other, which runs back.
std::string sides_fault_of(const JudgedMesh& mesh);

/// The same with points that are equal taken for one: as many sides have to run one way as the other.
std::string welded_fault_of(const JudgedMesh& mesh);

/// By the divergence theorem, in long doubles.
double volume_of(const JudgedMesh& mesh);

/// How often the mesh winds around a point: the sum of the solid angles of its triangles. None too near to a face.
int winding(const JudgedMesh& mesh, const glm::dvec3& point);

/// Parts of a mesh whose faces are joined along sides.
std::size_t parts_of(const JudgedMesh& mesh);

}  // namespace csgsim::testing
