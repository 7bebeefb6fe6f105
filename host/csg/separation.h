// Separation tests for convex hulls, boxes and primitives.
// Used by host/emit and sim/software.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "host/csg/counted.h"
#include "host/csg/hull.h"
#include "host/csg/pruning.h"
#include "host/facet/geometry.h"
#include "host/view/projection.h"

namespace csgsim::csg {

/// Whether a plane is found that strictly separates the hulls of two sets of points. Coordinates may have different
/// units, and the gap may be as small as 1e-9 of the larger hull. True is certain; false includes hulls that nearly
/// touch. Empty sets are not separated from anything.
///
/// Gilbert's algorithm (1966) iterates towards the point of the Minkowski difference nearest to the origin; a support
/// plane that excludes the origin proves separation.
bool separated(std::span<const glm::dvec3> first, std::span<const glm::dvec3> second, const Counted& counted = {});
bool separated(Hull& first, Hull& second, const Counted& counted = {});

/// A plane between two solids. Distances are in one unit, that of any linear function that is 0 on the plane.
struct Gap {
  double half = 0;        ///< the least distance of both solids from the plane
  double far_first = 0;   ///< no point of the first solid is farther from the plane
  double far_second = 0;  ///< no point of the second solid is farther from the plane

  /// Whether the gap is so wide that rounding in a usual view leaves it open.
  [[nodiscard]] bool is_wide() const { return half * 64 > far_first && half * 64 > far_second; }
};

/// Searches for a plane between two hulls as separated() does, but until the gap is wide. Returns the widest gap
/// relative to the solids; empty if none is found.
std::optional<Gap> find_gap(Hull& first, Hull& second, const Counted& counted = {});

/// Whether the boxes have no point in common.
bool disjoint(const facet::Box& first, const facet::Box& second);

/// Whether the prunings `picture` and `space`, as far as they are enabled, prove that two primitives have no point of
/// the picture and depth range in common.
bool disjoint(const view::View& view, std::uint32_t first, std::uint32_t second, const Pruning& pruning,
              const Counted& counted = {});

}  // namespace csgsim::csg
