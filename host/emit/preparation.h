// Counts of host work for transforming a model.
// Used by the compiler.
#pragma once

#include <cstdint>

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

/// Counts of the distinct numbers of a model that the host has to multiply by the camera's matrix. Numbers are compared
/// as integers of 32 bits, scaled to the model's size. The host finds them once per model.
struct DistinctNumbers {
  std::uint64_t coordinates = 0;  ///< distinct coordinates of corners, along x, y and z
  std::uint64_t components = 0;   ///< distinct components of normals, without their signs
  std::uint64_t directions = 0;   ///< normals of planes that are not parallel
};

DistinctNumbers count_distinct_numbers(const facet::Geometry& geometry);

/// The host work of finding the planes and numbers that half-spaces and corners of a model share, for any camera: a
/// table look-up of the plane for each half-space, and of the number for each coordinate, component and direction.
isa::Preparation count_sharing_work(const facet::Geometry& geometry);

/// The host work of transforming a model for a camera (docs/host.md): its planes and quadrics, and the points of its
/// solids. `is_sample`: the same camera's products and quotients are known, because only the sample positions differ.
isa::Preparation count_preparation(const facet::Geometry& geometry, const view::View& view,
                                   const DistinctNumbers& distinct, bool is_sample = false);

}  // namespace csgsim::emit
