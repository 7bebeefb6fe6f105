#pragma once

#include "hw/machines/kind.h"

namespace csgsim::pixel_square {

extern const machines::Kind kind;

}  // namespace csgsim::pixel_square
