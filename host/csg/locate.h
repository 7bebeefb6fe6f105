#pragma once

#include <cstdint>

#include "host/csg/counted.h"
#include "host/facet/geometry.h"
#include "host/view/projection.h"

namespace csgsim::csg {

/// What is known of something over a part of the picture and of the depth range.
enum class Known : std::uint8_t { out, in, depends };

/// A block of picture and depth: where the surface of a primitive can be.
struct Block {
  view::PixelRect pixels;
  std::int64_t z_low = 0;
  std::int64_t z_high = 0;
};

/// Least and greatest F = floor of the surface plane over the pixels.
view::Range depth_range(const view::ScreenPlane& plane, unsigned fraction_bits, const view::PixelRect& pixels);

/// Whether every point of the block, or none, is in the half-space, by the integers the machine will use. The extremes
/// of a plane over a rectangle are at its corners.
Known locate(const view::View& view, facet::Halfspace halfspace, const Block& block);

/// The same for one side of any plane.
Known locate(const view::View& view, const view::ScreenPlane& plane, bool positive, const Block& block);

/// The same for what is on that side of a quadric; nothing is known if it is unfit.
Known locate(const view::View& view, facet::QuadricSide side, const Block& block);

/// The same for a convex primitive: out if one half-space or quadric is out, in if all are in and the block is inside
/// its extent.
Known locate(const view::View& view, const facet::Geometry& geometry, std::uint32_t primitive, const Block& block,
             const Counted& counted = {});

/// Whether that is known to be in, found with no more half-spaces and quadrics than that takes.
bool holds(const view::View& view, const facet::Geometry& geometry, std::uint32_t primitive, const Block& block,
           const Counted& counted = {});

}  // namespace csgsim::csg
