#pragma once

#include <string_view>

namespace csgsim::report {

/// What page.css and page.js hold.
extern const std::string_view page_style;
extern const std::string_view page_script;

}  // namespace csgsim::report
