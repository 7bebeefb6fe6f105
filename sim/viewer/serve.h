// Opens the server module.
// Used by sim/app.
#pragma once

#include "sim/viewer/module.h"

namespace csgsim::viewer {

/// Opens the module and runs its server. Throws InputError if the module is missing or cannot serve.
void serve(const Serving& serving);

}  // namespace csgsim::viewer
