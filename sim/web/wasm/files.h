// Files handed over by the page.
// Used by session.cpp.
#pragma once

#include <string>

namespace csgsim::web {

/// Stores a text that read_file returns for the name. read_file rejects all other names.
void keep_file(std::string name, std::string text);

}  // namespace csgsim::web
