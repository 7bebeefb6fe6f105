// Tests of half-spaces, quadrics and primitives against a block of picture and depth.
// Used by host/effects, host/emit and sim/software.
#pragma once

#include <cstdint>

#include "host/csg/counted.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"

namespace csgsim::csg {

/// Location of a block relative to an object: outside everywhere, inside everywhere, or undecided.
enum class Containment : std::uint8_t { out, in, depends };

/// A block of picture and depth that contains the surface of a primitive.
struct Block {
  view::PixelRect pixels;
  std::int64_t z_low = 0;
  std::int64_t z_high = 0;
};

/// Range of F, the floor of the surface plane, over the pixels.
view::Range depth_range(const view::ScreenPlane& plane, unsigned fraction_bits, const view::PixelRect& pixels);

/// Whether every point of the block, or none, is in the half-space, by the integers that the machine uses. The extremes
/// of a plane over a rectangle are at its corners.
Containment locate(const view::View& view, facet::Halfspace halfspace, const Block& block);

/// Whether every point of the block, or none, is on the positive or negative side of the plane.
Containment locate(const view::View& view, const view::ScreenPlane& plane, bool positive, const Block& block);

/// Whether every point of the block, or none, is inside that side of a quadric; `depends` if the quadric is unfit.
Containment locate(const view::View& view, facet::QuadricSide side, const Block& block);

/// A half-space of a primitive that excluded a block.
struct Excluder {
  std::uint32_t halfspace = model::no_index;  ///< index in its solid; no_index if none has been found
  bool held = false;                          ///< whether it excluded the most recently tested block as well
};

/// Locates the block relative to a convex primitive: out if one half-space or quadric is out; in if all are in and the
/// block is inside the primitive's extent. The half-space of `excluder` is tested first; the one that excludes the
/// block is stored there.
Containment locate(const view::View& view, const facet::Geometry& geometry, std::uint32_t primitive, const Block& block,
                   const Counted& counted = {}, Excluder* excluder = nullptr);

/// Whether locate() returns `in`. Stops at the first half-space or quadric for which this is false.
bool holds(const view::View& view, const facet::Geometry& geometry, std::uint32_t primitive, const Block& block,
           const Counted& counted = {});

}  // namespace csgsim::csg
