#pragma once

#include "sim/app/description.h"

namespace CLI {
class App;
}

namespace csgsim::app {

/// What the library that reads the command line knows of it.
Description describe(CLI::App& app);

}  // namespace csgsim::app
