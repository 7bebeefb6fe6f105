#pragma once

#include <string>

namespace csgsim::web {

/// From now on read_file finds this text under the name. All other files are refused: a page has none.
void keep_file(std::string name, std::string text);

}  // namespace csgsim::web
