#pragma once

#include "host/emit/effect.h"

namespace csgsim::effects {

extern const emit::Effect equalise;

}  // namespace csgsim::effects
