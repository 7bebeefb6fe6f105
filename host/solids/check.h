#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/solids/mesh.h"

namespace csgsim::solids {

/// What keeps a mesh from being a solid, and the face (its number in the file) to point at.
struct Defect {
  std::uint32_t face = 0;
  std::string what;
};

/// A mesh and where it comes from.
struct Numbered {
  Mesh mesh;
  std::vector<std::uint32_t> point_numbers;  ///< of each point, its number in the file
  std::vector<std::uint32_t> face_numbers;   ///< of each face, its number in the file
};

/// Joins equal points, drops unused ones, and drops faces that collapse to an edge or a point by that, and pairs of
/// faces that are one and its back. Points and faces are numbered as they are given.
Numbered join_points(const Mesh& mesh);

/// An edge that faces do not run along as often in one direction as in the other.
std::optional<Defect> find_open_edge(const Numbered& numbered);

/// A point so far from the origin that numbers end (limits.h).
std::optional<Defect> find_far_point(const Numbered& numbered);

/// Joins points of edges that are open and nearer to each other than the tolerance, in model units, each with the first
/// one that it is near. Where nothing is open, nothing is joined, so that closed meshes stay as they are.
void join_near_points(Numbered& numbered, double tolerance);

/// Where an edge of a face runs along edges of others that meet on it, within the tolerance in model units, gives the
/// face corners there. Only edges that nothing joins are looked at, so that closed meshes stay as they are.
void join_edges(Numbered& numbered, double tolerance);

/// Turns shells that face the wrong way: those within an even number of others face outwards, those within an odd
/// number inwards. No other solid has this surface. Shells have to be closed and may not cross.
void turn_shells(Mesh& mesh);

/// Two faces that cross: of triangles of both, cut as in flat_faces.h, each reaches farther than the tolerance, in
/// model units, to either side of the other's plane, and they meet along more than that. What lies flat on another or
/// only touches it does not cross.
std::optional<Defect> find_crossing(const Numbered& numbered, double tolerance);

/// All of these in turn: a mesh that is closed, whose shells face the right way and do not cross; or what is wrong. The
/// tolerance is in units of the largest coordinate, and a part of an edge at most (limits.h).
struct Checked {
  Mesh mesh;
  std::optional<Defect> defect;
};

Checked check(const Mesh& mesh, double tolerance);

}  // namespace csgsim::solids
