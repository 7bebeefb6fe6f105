#pragma once

#include <cstddef>
#include <vector>

#include "host/emit/context.h"
#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// A convex solid's visible surface: the nearest of its front if it stands for itself, of its back if it is
/// complemented.
struct Surface {
  bool nothing = false;       ///< no pixel can have one; then nothing was emitted
  std::vector<Facet> facets;  ///< what Z1 can come from, in order; the first may be at depth 0
  csg::Block block;
  std::size_t begin = 0;  ///< instructions in the segment when E was left to the block's pixels, if it was emitted
};

/// Whether the facet's plane is nowhere before the range of depths, for a front, or nowhere behind it, for a back.
bool fits_depth(const Context& context, const Facet& facet, const csg::Block& block, bool is_front);

/// The depth of a curved facet where E is 1, in the field that it returns: `into`, if one is given that may be written,
/// or another. E stays 1 where the ray meets the quadric; before, it has to be 0 outside `enabled`, as for emit_root.
isa::Field emit_facet_depth(const Context& context, Broadcast& out, const Facet& facet, const view::PixelRect& pixels,
                            const view::PixelRect& enabled, isa::Field into = {});

/// What emit_surface would draw, without drawing it.
Surface surface_of(const Context& context, const PlannedSurface& planned, const Sides& sides);

/// The surface into Z1, and its colour beside it if there is a field for it. Leaves E 1 where there is one.
Surface emit_surface(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides);

/// E stays 1 where effects admit the surface in Z1, and it is behind the context's `beyond`.
void emit_admission(const Context& context, Broadcast& out, const PlannedSurface& planned);

/// Depth test: leaves E and the mask 1 where E is 1 and Z1 is nearer than Z2.
void emit_depth_test(const Context& context, Broadcast& out, const PlannedSurface& planned);

/// Copy of Z1 to Z2 where E is 1, and its colour or number. The mask has to be E.
void emit_merge(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface);

}  // namespace csgsim::emit
