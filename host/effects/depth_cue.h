#pragma once

#include "host/emit/effect.h"

namespace csgsim::effects {

extern const emit::Effect depth_cue;

}  // namespace csgsim::effects
