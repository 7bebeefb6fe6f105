#pragma once

#include "host/emit/effect.h"

namespace csgsim::effects {

extern const emit::Effect edges;

}  // namespace csgsim::effects
