// Counts of host work for transforming a model.
// Used by the compiler.
#pragma once

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

/// The host work of transforming a model for a camera (docs/host.md): its planes and quadrics, and the points of its
/// solids.
inline isa::Preparation count_preparation(const facet::Geometry& geometry, const view::View& view) {
  // A quadric has ten coefficients and a plane four, so that a quadric counts as three planes.
  constexpr std::uint64_t planes_of_quadric = 3;
  constexpr std::uint64_t corners_of_box = 8;
  isa::Preparation preparation;
  preparation.planes = view.planes.size() + planes_of_quadric * view.quadrics.size();
  for (const facet::Convex& solid : geometry.solids)
    preparation.points += solid.vertices.empty() ? corners_of_box : solid.vertices.size();
  return preparation;
}

}  // namespace csgsim::emit
