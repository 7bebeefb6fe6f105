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

/// Six times what the faces enclose, seen from the first of their points: negative if they face inwards.
double six_volumes(const Mesh& mesh, std::span<const std::uint32_t> faces);

/// The solid angle that a triangle is seen under from the origin, negative from behind (A. van Oosterom and J.
/// Strackee, 1983).
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// How many times closed faces run around a point: 1 within a shell that faces outwards, 0 outside it, and between them
/// on it.
double winding(const Mesh& mesh, std::span<const std::uint32_t> faces, const glm::dvec3& point);

/// The faces of each shell, in ascending order.
std::vector<FaceList> faces_of_shells(const Mesh& mesh);

/// How many other shells each is within. Shells may touch but not cross. Throws WorkError past the limit on work.
std::vector<std::uint32_t> depths_of(const Mesh& mesh, const std::vector<FaceList>& shells, const Work& work = {});

/// The faces of each solid: of a shell that faces outwards, and of the voids that are directly within it. Shells may
/// touch but not cross. Throws InputError for a void that is in no solid, and WorkError past the limit on work.
std::vector<FaceList> faces_of_solids(const Mesh& mesh, const Work& work);

}  // namespace csgsim::solids
