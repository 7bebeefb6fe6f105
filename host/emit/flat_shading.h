#pragma once

#include "host/emit/effect.h"

namespace csgsim::emit {

/// Every facet in one colour: the effect that every picture has, and whose facets are those that no other takes.
extern const EffectRow flat;

}  // namespace csgsim::emit
