// Volumes, winding numbers and nesting of a mesh's shells.
// Used throughout host/solids.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/solids/mesh.h"
#include "hw/base/work.h"

namespace csgsim::solids {

using FaceList = std::vector<std::uint32_t>;

facet::Box box_of(const Mesh& mesh, std::span<const std::uint32_t> faces);

/// Six times the enclosed volume, with the first point as apex; negative if the faces are oriented inwards.
double six_times_volume(const Mesh& mesh, std::span<const std::uint32_t> faces);

/// The solid angle of a triangle as seen from the origin; negative if seen from behind (A. van Oosterom and J.
/// Strackee, 1983).
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// The winding number of closed faces around a point: 1 inside a shell that faces outwards, 0 outside, and between 0
/// and 1 on the shell.
double winding(const Mesh& mesh, std::span<const std::uint32_t> faces, const glm::dvec3& point);

/// The faces of each shell, in ascending order.
std::vector<FaceList> collect_shells(const Mesh& mesh);

/// The number of other shells that contain each shell. Shells may touch but not cross. Throws WorkError if the work
/// limit is exceeded.
std::vector<std::uint32_t> nesting_depths(const Mesh& mesh, const std::vector<FaceList>& shells, const Work& work = {});

/// The faces of each solid: those of a shell that faces outwards, and of the voids directly inside it. Shells may touch
/// but not cross. Throws InputError for a void outside all solids, and WorkError if the work limit is exceeded.
std::vector<FaceList> collect_solids(const Mesh& mesh, const Work& work);

}  // namespace csgsim::solids
