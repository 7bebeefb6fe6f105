// Checks and repairs that turn a mesh into the closed surface of a solid.
// Used throughout host/solids and by host/read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/solids/mesh.h"

namespace csgsim::solids {

/// The reason why a mesh is not a solid, and the file number of the face to report.
struct Defect {
  std::uint32_t face = 0;
  std::string what;
};

/// A mesh with the file numbers of its points and faces.
struct NumberedMesh {
  Mesh mesh;
  std::vector<std::uint32_t> point_numbers;  ///< file number of each point
  std::vector<std::uint32_t> face_numbers;   ///< file number of each face
};

/// Joins equal points and drops unused ones. Drops faces that collapse to an edge or a point in the process, and pairs
/// of faces that are each other's reverse. Points and faces are numbered in the given order.
NumberedMesh join_points(const Mesh& mesh);

/// Finds an edge along which faces do not run equally often in both directions; empty if there is none.
std::optional<Defect> find_open_edge(const NumberedMesh& numbered);

/// Finds a point beyond the range of coordinates (limits.h); empty if there is none.
std::optional<Defect> find_far_point(const NumberedMesh& numbered);

/// Joins end points of open edges that are closer to each other than the tolerance, in model units. Each joins the
/// first point near it. Closed meshes stay unchanged.
void join_near_points(NumberedMesh& numbered, double tolerance);

/// Inserts corners into a face where one of its edges runs along shorter edges of other faces that end on it, within
/// the tolerance in model units. Only open edges are considered, so closed meshes stay unchanged.
void join_edges(NumberedMesh& numbered, double tolerance);

/// Faces whose orientation was reversed.
struct TurnedFaces {
  std::uint32_t count = 0;
  std::uint32_t first = 0;  ///< lowest of their numbers in the file
};

/// Reverses faces that run along an edge in the same direction as the only other face there. Of each connected group it
/// reverses the minority or, if both are equal, those that run against the first face. Groups without a consistent
/// orientation, such as a one-sided surface, stay unchanged.
TurnedFaces turn_faces(NumberedMesh& numbered);

/// Reverses shells with the wrong orientation: shells within an even number of others must face outwards, those within
/// an odd number inwards. The result is the only solid with this surface. Shells must be closed and must not cross.
void turn_shells(Mesh& mesh);

/// The placement of a mesh where OpenSCAD cuts its faces into triangles.
struct MeshPlacement {
  /// Maps the mesh to the space in which it is shown alone or first combined with other solids.
  glm::dmat4 transform{1};
  bool is_reversed = false;  ///< whether faces run opposite to OpenSCAD's, as those of polyhedron() do
  /// Whether the mesh is part of a union, difference or intersection, where corners are rounded to a grid of 2^-20.
  bool meets_others = false;
};

/// Faces that were cut because they are not flat.
struct BentFaces {
  std::uint32_t count = 0;
  std::uint32_t first = 0;   ///< file number of the first one
  double max_deviation = 0;  ///< maximum distance of a corner from its face's plane, in model units
  /// File number of the first face that OpenSCAD may triangulate differently.
  std::optional<std::uint32_t> first_different;
};

/// Cuts faces that have a corner farther off their plane than the tolerance, in model units, into the triangles that
/// OpenSCAD 2021.01 shows (tessellation.h). A face that crosses itself in OpenSCAD's projection stays unchanged.
BentFaces cut_bent_faces(NumberedMesh& numbered, double tolerance, const MeshPlacement& placement);

/// Faces that cross each other.
struct Crossing {
  std::uint32_t one = 0;    ///< lower file number of the pair with the greatest depth
  std::uint32_t other = 0;  ///< higher file number of that pair
  /// How far the two faces reach past each other, or the length of their crossing if that is less, in model units.
  double depth = 0;
  std::size_t count = 0;  ///< number of crossing pairs of faces
};

/// Finds crossing faces; empty if there are none. Two faces cross if two of their triangles (cut as in flat_faces.h)
/// each reach farther than the tolerance, in model units, to both sides of the other's plane, and intersect along a
/// line longer than the tolerance. Faces that lie flat on each other or only touch do not cross.
std::optional<Crossing> find_crossing(const NumberedMesh& numbered, double tolerance);

/// The result of all these checks: a closed mesh whose shells are correctly oriented and do not cross, or the reason
/// why the mesh is not a solid. The tolerance is in units of the largest coordinate, and is limited to a fraction of
/// the median edge (limits.h).
struct CheckedMesh {
  Mesh mesh;
  std::optional<Defect> defect;
  std::optional<Crossing> crossing{};  ///< set only for a closed mesh; its shells are then unchanged
  BentFaces bent{};
  TurnedFaces turned{};
};

CheckedMesh check(const Mesh& mesh, double tolerance, const MeshPlacement& placement = {});

}  // namespace csgsim::solids
