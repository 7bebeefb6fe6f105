#pragma once

#include <string>
#include <string_view>

namespace csgsim::web {

/// RFC 1950 and 1951, without compression: there is no zlib here.
std::string stored(std::string_view bytes);

}  // namespace csgsim::web
