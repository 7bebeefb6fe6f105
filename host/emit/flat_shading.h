// Flat shading: every facet in one colour.
// Used by the table of effect rows.
#pragma once

#include "host/emit/effect.h"

namespace csgsim::emit {

/// The effect that every picture has. It colours the facets that no other effect takes.
extern const EffectRow flat;

}  // namespace csgsim::emit
