#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/effects/outline.h"
#include "host/effects/shadow_volumes.h"
#include "host/emit/context.h"

namespace csgsim::effects {

/// A facet that may be seen in the light, at the depths of its plane.
struct Receiver {
  std::uint32_t primitive = 0;
  facet::Halfspace halfspace;
  view::FixedLinear plane;
  Outline outline;  ///< holds its pixels
};

/// What is seen in a region where a light makes a difference. What the near plane cuts open is no receiver: it is a
/// section, which is shown as if it were lit.
struct Receivers {
  std::vector<Receiver> facets;
};

Receivers receivers_of(const emit::Context& context, std::size_t light);

}  // namespace csgsim::effects
