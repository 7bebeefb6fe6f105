#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
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

/// Faces that were turned.
struct TurnedFaces {
  std::uint32_t count = 0;
  std::uint32_t first = 0;  ///< the lowest of their numbers in the file
};

/// Turns faces that run along an edge the same way as the only other face there: of all that are joined so, the fewer,
/// or those that run against the first. Where no turning helps, as on a surface with one side, they stay.
TurnedFaces turn_faces(Numbered& numbered);

/// Turns shells that face the wrong way: those within an even number of others face outwards, those within an odd
/// number inwards. No other solid has this surface. Shells have to be closed and may not cross.
void turn_shells(Mesh& mesh);

/// Where a mesh stands when OpenSCAD cuts its faces into triangles.
struct Standing {
  glm::dmat4 transform{1};    ///< from the mesh to where it is shown alone or first meets others
  bool runs_back = false;     ///< faces run the other way than OpenSCAD's do, as those of polyhedron()
  bool meets_others = false;  ///< in a union, a difference or an intersection, where corners are on a grid of 2^-20
};

/// What was cut.
struct BentFaces {
  std::uint32_t count = 0;
  std::uint32_t first = 0;              ///< its number in the file
  double most_off = 0;                  ///< the farthest that a corner of one is off its face's plane, in model units
  std::optional<std::uint32_t> unlike;  ///< the first, by its number, of which OpenSCAD may make other triangles
};

/// Cuts faces with a corner farther off their plane than the tolerance, in model units, into the triangles that
/// OpenSCAD 2021.01 shows (tessellation.h). One that crosses itself, as OpenSCAD looks at it, stays.
BentFaces cut_bent_faces(Numbered& numbered, double tolerance, const Standing& standing);

/// Faces that cross each other.
struct Crossing {
  std::uint32_t one = 0;    ///< of the two that cross deepest, by their numbers in the file
  std::uint32_t other = 0;  ///< the larger number
  double depth = 0;         ///< how far these reach past each other, or cross along if that is less, in model units
  std::size_t count = 0;    ///< pairs of faces that cross
};

/// Two faces cross if, of triangles of both, cut as in flat_faces.h, each reaches farther than the tolerance, in model
/// units, to either side of the other's plane, and they meet along more than that. What lies flat on another or only
/// touches it does not cross.
std::optional<Crossing> find_crossing(const Numbered& numbered, double tolerance);

/// All of these in turn: a mesh that is closed, whose shells face the right way and do not cross; or what is wrong. The
/// tolerance is in units of the largest coordinate, and a part of an edge at most (limits.h).
struct Checked {
  Mesh mesh;
  std::optional<Defect> defect;
  std::optional<Crossing> crossing{};  ///< of a closed mesh, whose shells are then as they are given
  BentFaces bent{};
  TurnedFaces turned{};
};

Checked check(const Mesh& mesh, double tolerance, const Standing& standing = {});

}  // namespace csgsim::solids
