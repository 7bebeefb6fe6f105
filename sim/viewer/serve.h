#pragma once

#include "sim/viewer/module.h"

namespace csgsim::viewer {

/// Opens the module and serves by it. Throws InputError where there is no such module, or it cannot serve.
void serve(const Serving& serving);

}  // namespace csgsim::viewer
