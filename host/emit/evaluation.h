#pragma once

#include "host/emit/context.h"
#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// Memory bits that the strategy takes for the whole drawing. Throws InputError where it cannot do it (see
/// most_products).
ClassificationBits classification_bits(const Drawing& drawing, const Options& options);

/// Draws one primitive's visible surface where its active tree holds it. `options.strategy` must not be automatic.
void emit_primitive(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides);

}  // namespace csgsim::emit
