#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/solids/mesh.h"
#include "host/swept/output.h"
#include "host/swept/sweep.h"
#include "host/swept/wire_frame.h"

namespace csgsim::swept {

/// Who makes the elements of a mesh meet.
enum class Repair : std::uint8_t { filter, quadtree };

/// A surface as elements that meet: where a vertex is on a side, it is one of the element's corners.
struct Patchwork {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> elements;
  SubdivisionCounts wiring;       ///< of the edges between patches, where there are several
  SubdivisionCounts subdivision;  ///< of the patches
  RepairCounts repair;            ///< the most that is held is that of one patch
  std::uint64_t wire_vertices = 0;
};

/// Subdivides and repairs all patches; one that is next to none has no wire frame. Throws InputError as
/// Surface::subdivide does.
Patchwork patchwork_of(Surface& surface, const Accuracy& accuracy, Repair repair = Repair::filter);

/// A swept solid.
struct SweptSolid {
  solids::Mesh mesh;    ///< closed, faces outwards; elements that are not flat are cut into triangles
  Patchwork patchwork;  ///< without base and cap
};

/// Base and cap are a face each, of what the surface has on their edges; where the trajectory is closed or the scale is
/// 0 there is none. Of a sweep without fault; throws InputError as patchwork_of does.
SweptSolid solid_of(const Sweep& sweep, const Accuracy& accuracy, Repair repair = Repair::filter);

}  // namespace csgsim::swept
