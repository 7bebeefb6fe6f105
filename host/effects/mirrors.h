#pragma once

#include "host/emit/effect.h"

namespace csgsim::effects {

extern const emit::Effect mirrors;

}  // namespace csgsim::effects
