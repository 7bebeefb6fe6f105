#pragma once

#include "host/emit/effect.h"

namespace csgsim::effects {

/// Cutting planes, with caps and hatching.
extern const emit::Effect cuts;

}  // namespace csgsim::effects
