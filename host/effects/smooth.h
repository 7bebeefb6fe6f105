#pragma once

#include "host/emit/effect.h"

namespace csgsim::effects {

extern const emit::Effect smooth;

}  // namespace csgsim::effects
