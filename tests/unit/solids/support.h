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

/// tests/models/solids/NAME.off, as OpenSCAD wrote it.
solids::Mesh load_off(const std::string& name);

/// Six faces.
solids::Mesh box(const glm::dvec3& low, const glm::dvec3& high);

void reverse(solids::Mesh& mesh);
void append(solids::Mesh& mesh, const solids::Mesh& other);

struct Extent {
  glm::dvec3 low;
  glm::dvec3 high;
};

Extent extent_of(std::span<const glm::dvec3> points);

/// By the divergence theorem, about the middle of the points, in long doubles.
double volume_of(std::span<const glm::dvec3> points, const std::vector<std::vector<std::uint32_t>>& faces);

double volume_of(std::span<const model::Polyhedron> pieces);

/// Whether a ray from the point crosses the surface an odd number of times. Nothing where the point or the ray is so
/// near to an edge or a face that rounding may decide.
std::optional<bool> is_inside(const solids::Mesh& mesh, const glm::dvec3& point);

/// How many of the pieces hold a point, by their planes. Nothing where it is within the distance of one of the planes.
std::optional<int> pieces_at(std::span<const model::Polyhedron> pieces, const glm::dvec3& point, double clear);

glm::dvec3 random_point(std::mt19937_64& random, const Extent& extent);

/// Each point inside, and none outside, is in just one piece; corners are on their planes; the volumes add up, but for
/// `loss` of it. The number of points that were inside.
int check_pieces(const solids::Mesh& mesh, std::span<const model::Polyhedron> pieces, double loss);

glm::dmat3 random_rotation(std::mt19937_64& random);

}  // namespace csgsim::testing
