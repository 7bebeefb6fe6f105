#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/commands/model.h"
#include "host/model/tree.h"
#include "host/read/read.h"

namespace csgsim::commands {

/// The tree of a file of commands, the language of the thesis (2.3; docs/reproduction.md). Throws InputError with
/// file:line:column. Of the options, the limit on work counts.
model::Tree read_text(std::string_view text, std::string_view name, const read::Options& options = {});

/// A surface of a file of commands that is subdivided.
struct NamedSurface {
  std::string name;
  bool is_sweep = false;
  swept::Sweep sweep;  ///< or else
  swept::Net net;
  double tolerance = 0;  ///< that the file says
  model::Location location;
};

/// All sweeps and patches of a file, in the order of its lines; of one name, the last. Throws InputError as read_text
/// does.
std::vector<NamedSurface> surfaces_in(std::string_view text, std::string_view name);

}  // namespace csgsim::commands
