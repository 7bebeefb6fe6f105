#pragma once

#include <string>
#include <vector>

#include "host/csg/pruning.h"

namespace csgsim::session {

/// Which prunings are done, as options and studies say it: `all`, `none`, those that are done (`space+hidden`), or
/// those that are not (`no-space+no-hidden`). Throws UsageError.
csg::Pruning pruning_of(const std::string& text);

/// The same for a list of them with commas. Throws UsageError.
std::vector<std::string> prunings_of(const std::string& text);

/// The words that such a text is made of.
std::vector<std::string> pruning_words();

}  // namespace csgsim::session
