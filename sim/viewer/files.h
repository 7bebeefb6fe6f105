#pragma once

#include <string_view>

namespace csgsim::viewer {

/// Files of this folder, which are part of the program.
extern const std::string_view page_html;
extern const std::string_view view_style;
extern const std::string_view view_script;

}  // namespace csgsim::viewer
