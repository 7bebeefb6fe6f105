#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "host/model/tree.h"
#include "host/solids/mesh.h"

namespace csgsim::testing {

/// Loads tests/models/solids/NAME.off, as OpenSCAD wrote it.
solids::Mesh load_off(const std::string& name);

/// A box of six faces.
solids::Mesh box(const glm::dvec3& low, const glm::dvec3& high);

void reverse(solids::Mesh& mesh);
void append(solids::Mesh& mesh, const solids::Mesh& other);

struct Extent {
  glm::dvec3 low;
  glm::dvec3 high;
};

Extent extent_of(std::span<const glm::dvec3> points);

/// Volume by the divergence theorem, about the middle of the points, in long doubles.
double volume_of(std::span<const glm::dvec3> points, const std::vector<std::vector<std::uint32_t>>& faces);

double volume_of(std::span<const model::Polyhedron> pieces);

/// Whether a ray from the point crosses the surface an odd number of times. Nothing if the point or the ray is so close
/// to an edge or a face that rounding may decide.
std::optional<bool> is_inside(const solids::Mesh& mesh, const glm::dvec3& point);

/// Number of pieces that contain a point, by their planes. Nothing if it is within `clear` of one of the planes.
std::optional<int> count_pieces_at(std::span<const model::Polyhedron> pieces, const glm::dvec3& point, double clear);

glm::dvec3 random_point(std::mt19937_64& random, const Extent& extent);

/// Checks that each point inside, and none outside, is in exactly one piece, that corners are on their planes, and that
/// the volumes add up except for `loss`. Returns the number of points inside.
int check_pieces(const solids::Mesh& mesh, std::span<const model::Polyhedron> pieces, double loss);

glm::dmat3 random_rotation(std::mt19937_64& random);

}  // namespace csgsim::testing
