// Serves the files of the page.
// Used by sim/app.
#pragma once

#include <optional>
#include <string_view>

#include "sim/viewer/http.h"

namespace csgsim::viewer {

/// A file of the page by its path behind the token; nothing for an unknown path.
std::optional<Reply> page_file(std::string_view path);

}  // namespace csgsim::viewer
