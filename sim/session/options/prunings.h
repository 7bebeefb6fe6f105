// Parses selections of prunings.
// Used by sim/session, sim/app and sim/studies.
#pragma once

#include <string>
#include <vector>

#include "host/csg/pruning.h"

namespace csgsim::session {

/// Parses a selection of prunings: `all`, `none`, those to apply (`space+hidden`), or those to leave out
/// (`no-space+no-hidden`). Throws UsageError.
csg::Pruning pruning_of(const std::string& text);

/// Splits and validates a comma-separated list of selections. Throws UsageError.
std::vector<std::string> prunings_of(const std::string& text);

/// The words from which a selection is composed.
std::vector<std::string> pruning_words();

}  // namespace csgsim::session
