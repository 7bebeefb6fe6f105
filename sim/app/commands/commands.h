#pragma once

#include "sim/shell/command_line.h"

namespace csgsim::app {

using namespace session;  // whose requests commands read,
using namespace shell;    // and show

/// Every command but studies, in the order of help: NAME.cpp describes the command NAME in add_NAME. Its subject in
/// help is in sim/shell/option_table.cpp.
#define CSGSIM_COMMANDS(COMMAND) \
  COMMAND(render)                \
  COMMAND(compile)               \
  COMMAND(run)                   \
  COMMAND(rerun)                 \
  COMMAND(disasm)                \
  COMMAND(convert)               \
  COMMAND(debug)                 \
  COMMAND(diff)                  \
  COMMAND(view)                  \
  COMMAND(explain)               \
  COMMAND(wave)                  \
  COMMAND(rtl)                   \
  COMMAND(effects)               \
  COMMAND(levels)                \
  COMMAND(manual)

#define CSGSIM_COMMAND_DECLARATION(name) void add_##name(CommandLine& line);
CSGSIM_COMMANDS(CSGSIM_COMMAND_DECLARATION)
#undef CSGSIM_COMMAND_DECLARATION

}  // namespace csgsim::app
