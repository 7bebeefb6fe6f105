#pragma once

#include "host/emit/context.h"
#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// Scan-conversions, as table 6.1 of the thesis counts them.
struct ScanConversions {
  std::uint64_t rendered = 0;     ///< surfaces into Z1
  std::uint64_t classified = 0;   ///< primitives of active trees compared with Z1
  std::uint64_t depth_tests = 0;  ///< Z1 compared with Z2
};

/// Memory bits that the strategy takes for the whole plan. Throws InputError where it cannot do it (see most_products).
ClassificationBits classification_bits(const model::Tree& tree, const Plan& plan, const Options& options);

/// Draws one primitive's visible surface where its active tree holds it. `options.strategy` must not be automatic.
void emit_primitive(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides,
                    ScanConversions& counts);

}  // namespace csgsim::emit
