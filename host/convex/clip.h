#pragma once

#include <cstdint>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"

namespace csgsim::convex {

/// Points this near to a plane, relative to the model's diagonal, are on it. Planes that differ by less than
/// facet::coincidence_tolerance are one plane, so that this many times as much tells corners that planes share from
/// corners that they do not. Rounding errs by some 1e-15.
inline constexpr double relative_tolerance = 10.0 * facet::coincidence_tolerance;

/// The same in model units.
double tolerance(const facet::PlaneTable& planes);

/// What of a polytope is in the half-space. No vertex is moved: one that is on the plane stays, though it may be out by
/// the tolerance, and where edges cross the plane there are new ones. What is lost is thinner than the tolerance, a
/// sheet along the plane: all of the polytope where no vertex is farther in. What is kept too much is as thin.
///
/// Should vertices that are on a face only by the tolerance make the cut other than one polygon, it is made with parts
/// of the tolerance, and then with multiples, until it is one.
Polytope clip(Polytope polytope, facet::Halfspace halfspace, const facet::PlaneTable& planes);

/// Steps of work (hw/base/work.h) that it takes to cut a polytope once of which so many vertices are looked at, about.
std::uint64_t clip_steps(std::uint64_t vertices);

/// The same of clip().
std::uint64_t clip_steps(const Polytope& polytope);

/// The other side of the plane.
constexpr facet::Halfspace opposite(facet::Halfspace halfspace) { return {halfspace.plane, !halfspace.positive}; }

/// normal . p + offset <= 0 in the half-space, offset relative to PlaneTable::centre().
facet::Plane outward_plane(facet::Halfspace halfspace, const facet::PlaneTable& planes);

}  // namespace csgsim::convex
