#pragma once

#include "hw/machines/kind.h"

namespace csgsim::scan_line {

extern const machines::Kind kind;

}  // namespace csgsim::scan_line
