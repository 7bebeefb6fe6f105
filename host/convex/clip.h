// Clipping of a polytope by a half-space.
// Used throughout host/convex and by host/effects, host/solids and sim/software.
#pragma once

#include <cstdint>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"

namespace csgsim::convex {

/// Points closer to a plane than this, relative to the model's diagonal, are treated as on it. Planes that differ by
/// less than facet::coincidence_tolerance are treated as one plane, so this is a multiple of that tolerance, to
/// distinguish shared corners from distinct ones. Rounding errors are about 1e-15.
inline constexpr double relative_tolerance = 10.0 * facet::coincidence_tolerance;

/// The tolerance in model units.
double tolerance(const facet::PlaneTable& planes);

/// The part of a polytope inside a half-space. Vertices are not moved: a vertex on the plane stays, even if it is
/// outside by up to the tolerance, and new vertices are added where edges cross the plane. Lost parts are thinner than
/// the tolerance, in a sheet along the plane; if no vertex is farther inside than the tolerance, the whole polytope is
/// lost. Excess parts are equally thin.
///
/// If the cross-section is not a single polygon, because of vertices within the tolerance, the cut is repeated with
/// fractions and then with multiples of the tolerance until it is one.
Polytope clip(Polytope polytope, facet::Halfspace halfspace, const facet::PlaneTable& planes);

/// Approximate cost, in steps of work (hw/base/work.h), of one cut that visits `vertex_count` vertices.
std::uint64_t clip_steps(std::uint64_t vertex_count);

/// Approximate cost of clip(), in steps of work.
std::uint64_t clip_steps(const Polytope& polytope);

/// The half-space on the other side of the plane.
constexpr facet::Halfspace opposite(facet::Halfspace halfspace) { return {halfspace.plane, !halfspace.positive}; }

/// The outward plane: normal . p + offset <= 0 inside the half-space, with the offset relative to PlaneTable::centre().
facet::Plane outward_plane(facet::Halfspace halfspace, const facet::PlaneTable& planes);

}  // namespace csgsim::convex
