#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/read/mesh.h"

namespace csgsim::read {

/// Planes of the faces of a mesh whose points are scaled to [-1, 1] and moved to the origin.
struct Planes {
  double scale = 1;                 ///< model units of a unit here: the largest coordinate
  double size = 0;                  ///< diagonal of the bounding box
  std::vector<glm::dvec3> points;   ///< the mesh's, scaled
  std::vector<glm::dvec3> normals;  ///< of length 1, or 0 for a face without area
  std::vector<double> distances;    ///< normal · point on the plane
  std::vector<double> areas;
};

/// The planes by Newell's sums, through the mean of the corners.
Planes fit_planes(const Mesh& mesh);

/// A face whose corners are on a line.
std::optional<Defect> find_face_without_area(const Mesh& mesh, const Planes& planes);

/// Whether all points are in one plane, but for the rounding of doubles.
bool is_flat(const Mesh& mesh, const Planes& planes);

/// Reverses all faces if they run clockwise seen from outside.
void turn_outwards(Mesh& mesh, Planes& planes);

/// A face with a corner off its plane.
std::optional<Defect> find_bent_face(const Mesh& mesh, const Planes& planes);

/// A face with a point outside it.
std::optional<Defect> find_dent(const Mesh& mesh, const Planes& planes);

}  // namespace csgsim::read
