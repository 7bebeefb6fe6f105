// The manual page of scene files.
// Used by sim/app.
#pragma once

#include <string>

namespace csgsim::effects {

/// The manual page of scene files, with all effects, in Markdown.
std::string scene_page();

}  // namespace csgsim::effects
