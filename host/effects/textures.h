#pragma once

#include "host/emit/effect.h"

namespace csgsim::effects {

extern const emit::Effect textures;

}  // namespace csgsim::effects
