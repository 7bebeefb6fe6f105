#pragma once

#include "hw/machines/kind.h"

namespace csgsim::multi_processor {

extern const machines::Kind kind;

}  // namespace csgsim::multi_processor
