#pragma once

#include <string>
#include <string_view>

namespace csgsim::web {

/// RFC 1950 and 1951 in little time: by the fixed codes, and of repetitions only those of one byte. There is no zlib
/// here.
std::string deflated(std::string_view bytes);

}  // namespace csgsim::web
