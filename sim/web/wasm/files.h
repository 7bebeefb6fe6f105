// Files handed over by the page.
// Used by session.cpp.
#pragma once

#include <string>

namespace csgsim::web {

/// Makes read_file return this text for the name. All other files are refused.
void keep_file(std::string name, std::string text);

}  // namespace csgsim::web
