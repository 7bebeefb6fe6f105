// Colours of facets and surfaces, by the effects called.
// Used by host/effects.
#pragma once

#include "host/emit/context.h"
#include "host/emit/halfspaces.h"
#include "host/emit/surface.h"

namespace csgsim::emit {

/// Whether an effect may colour facets, so that emit_colour may clear E.
bool has_shaders(const Context& context);

/// Whether a light changes the instructions of emit_colour for a facet.
bool light_matters(const Context& context, const Facet& facet, const view::PixelRect& pixels, std::size_t light);

/// Colours a facet into `field` where E is 1, by the last called effect that accepts it. E is 0 outside `pixels`.
void emit_colour(const Context& context, Broadcast& out, const Facet& facet, isa::Field field,
                 const view::PixelRect& pixels);

/// Colours the facets of a surface at the pixels where E is 1, which must be those that show it. Each facet is found by
/// comparing its depth with `depth`, the field that holds the surface's depth; where facets meet, the first counts.
/// Changes `mask`.
void emit_facet_colours(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                        isa::Field depth, const Shadows& shadows);

/// Colours a surface at the pixels that it owns.
void emit_visible_colours(const Context& context, Broadcast& out, const PlannedSurface& planned,
                          const Shadows& shadows);

}  // namespace csgsim::emit
