// A small, fast zlib compressor.
// Used by png.cpp.
#pragma once

#include <string>
#include <string_view>

namespace csgsim::web {

/// Compresses to a zlib stream (RFC 1950 and 1951) with fixed codes, in which only runs of one byte are shortened.
/// Replaces zlib on the web.
std::string compress_zlib(std::string_view bytes);

}  // namespace csgsim::web
