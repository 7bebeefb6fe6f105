#pragma once

#include "host/emit/effect.h"

namespace csgsim::effects {

/// Exact shadows of CSG models.
extern const emit::Effect shadows;

}  // namespace csgsim::effects
