#pragma once

#include "host/emit/effect.h"

namespace csgsim::effects {

extern const emit::Effect transparency;

}  // namespace csgsim::effects
