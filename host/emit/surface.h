// The visible surface of a convex solid, its depth test and its merge.
// Used by host/effects.
#pragma once

#include <cstddef>
#include <vector>

#include "host/emit/context.h"
#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// A convex solid's visible surface: its front, or its back if it is complemented.
struct Surface {
  bool nothing = false;       ///< no pixel can show a surface, and nothing was emitted
  std::vector<Facet> facets;  ///< the facets that Z1 can come from, in order; the first may be at depth 0
  csg::Block block;
  std::size_t begin = 0;  ///< number of instructions in the segment when E had been restricted to the block's pixels,
                          ///< if emitted
};

/// Whether the plane's depth over the block's pixels is at least 0 everywhere (for a front), or at most the maximum
/// depth everywhere (for a back).
bool fits_depth(const Context& context, const Facet& facet, const csg::Block& block, bool is_front);

/// Computes the depth of a curved facet where E is 1. Returns its field: `into` if given and writable, or another. E
/// stays 1 where the ray meets the quadric; before the call it must be 0 outside `enabled`, as for emit_root.
isa::Field emit_facet_depth(const Context& context, Broadcast& out, const Facet& facet, const view::PixelRect& pixels,
                            const view::PixelRect& enabled, isa::Field into = {});

/// Determines the surface that emit_surface() would draw. Appends no instructions.
Surface plan_surface(const Context& context, const PlannedSurface& planned, const Sides& sides);

/// Draws the surface into Z1, and its colour if there is a field for it. E is 1 where there is a surface.
Surface emit_surface(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides);

/// E stays 1 where effects admit the surface in Z1 and it is behind the context's `beyond`.
void emit_admission(const Context& context, Broadcast& out, const PlannedSurface& planned);

/// Depth test: E and the mask become 1 where E is 1 and Z1 is nearer than Z2.
void emit_depth_test(const Context& context, Broadcast& out, const PlannedSurface& planned);

/// Copies Z1, and its colour or number, to Z2 where E is 1. The mask must equal E.
void emit_merge(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface);

}  // namespace csgsim::emit
