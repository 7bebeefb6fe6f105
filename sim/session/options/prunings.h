// Parses selections of prunings.
// Used by sim/session, sim/app and sim/studies.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/csg/pruning.h"

namespace csgsim::session {

/// The selection of all prunings, each applied where it is worth its time (csg::Prices).
inline constexpr std::string_view automatic_pruning = "auto";

/// Parses a selection of prunings: `auto`, `all`, `none`, those to apply (`space+hidden`), or those to leave out
/// (`no-space+no-hidden`). Throws UsageError.
csg::Pruning parse_pruning(const std::string& text);

/// Splits and validates a comma-separated list of selections. Throws UsageError.
std::vector<std::string> parse_prunings(const std::string& text);

/// The words from which a selection is composed.
std::vector<std::string> pruning_words();

}  // namespace csgsim::session
