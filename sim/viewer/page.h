#pragma once

#include <optional>
#include <string_view>

#include "sim/viewer/http.h"

namespace csgsim::viewer {

/// The page itself, its style or its script, by the path behind the token; nothing for any other.
std::optional<Reply> page_file(std::string_view path);

}  // namespace csgsim::viewer
