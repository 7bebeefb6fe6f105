// Reads files of commands, the language of the thesis, as CSG trees or surfaces.
// Used by sim/session and sim/studies.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/commands/model.h"
#include "host/model/tree.h"
#include "host/read/read.h"

namespace csgsim::commands {

/// Reads a file of commands, in the language of the thesis (2.3; docs/reproduction.md), as a CSG tree. Throws
/// InputError with file:line:column. Of the options, only the limit on work applies.
model::Tree read_text(std::string_view text, std::string_view name, const read::Options& options = {});

/// A surface in a file of commands, which can be subdivided.
struct NamedSurface {
  std::string name;
  bool is_sweep = false;
  swept::Sweep sweep;    ///< valid if is_sweep
  swept::Net net;        ///< valid if not is_sweep
  double tolerance = 0;  ///< of its subdivision, in model units
  model::Location location;
};

/// All sweeps and patches of a file, in the order of its lines; of several with one name, only the last. Throws
/// InputError as read_text() does.
std::vector<NamedSurface> read_surfaces(std::string_view text, std::string_view name);

}  // namespace csgsim::commands
