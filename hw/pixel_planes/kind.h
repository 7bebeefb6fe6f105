#pragma once

#include "hw/machines/kind.h"

namespace csgsim::pixel_planes {

extern const machines::Kind kind;

}  // namespace csgsim::pixel_planes
