// Facets on which shadows may fall.
// Used by the shadow effect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/effects/outline.h"
#include "host/effects/shadow_volumes.h"
#include "host/emit/context.h"

namespace csgsim::effects {

/// A facet that may be visible and lit, at the depths of its plane.
struct Receiver {
  std::uint32_t primitive = 0;
  facet::Halfspace halfspace;
  view::FixedLinear plane;
  Outline outline;  ///< polygon that contains its pixels
};

/// The facets in a region that a light affects. Caps at the near plane are not receivers: they are sections, which are
/// shown as if lit.
struct Receivers {
  std::vector<Receiver> facets;
};

Receivers find_receivers(const emit::Context& context, std::size_t light);

}  // namespace csgsim::effects
