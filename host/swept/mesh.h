// Conforming meshes of surfaces, and swept solids.
// Used by host/commands and sim/studies.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/solids/mesh.h"
#include "host/swept/output.h"
#include "host/swept/sweep.h"
#include "host/swept/wire_frame.h"

namespace csgsim::swept {

/// The method that makes the mesh conforming.
enum class Repair : std::uint8_t { filter, quadtree };

/// A surface as a conforming mesh: every vertex on the side of an element is one of the element's corners.
struct Patchwork {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> elements;
  SubdivisionCounts wiring;       ///< counts for the edges between patches, if there are several
  SubdivisionCounts subdivision;  ///< counts for the patches
  RepairCounts repair;            ///< peak counts are the maxima over single patches
  std::uint64_t wire_vertices = 0;
};

/// Subdivides and repairs all patches. A single patch without neighbours needs no wire frame. Throws InputError as
/// Surface::subdivide() does.
Patchwork make_patchwork(Surface& surface, const Accuracy& accuracy, Repair repair = Repair::filter);

/// A swept solid.
struct SweptSolid {
  solids::Mesh mesh;    ///< closed and facing outwards; elements that are not flat are cut into triangles
  Patchwork patchwork;  ///< the swept surface, without base and cap
};

/// Builds the solid of a valid sweep. Base and cap are one face each, bounded by the surface's edge vertices; they are
/// omitted if the trajectory is closed or the scale is 0 there. Throws InputError as make_patchwork() does.
SweptSolid make_swept_solid(const Sweep& sweep, const Accuracy& accuracy, Repair repair = Repair::filter);

}  // namespace csgsim::swept
