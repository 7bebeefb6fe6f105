#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "tests/support/off_file.h"

namespace csgsim::testing {

/// Largest distance between two corners of the mesh's bounding box.
double diagonal(const Mesh& mesh);

/// Distance from the eye along the view axis at every pixel centre of a square picture, infinite for the background.
/// Compares every triangle with every pixel in double precision. An independent judge of csgsim's pictures that shares
/// no code with them. Up is +z, the field of view 22.5 degrees.
std::vector<double> mesh_depth(const Mesh& mesh, const glm::dvec3& eye, const glm::dvec3& centre, bool perspective,
                               int size);

}  // namespace csgsim::testing
