// A small, fast zlib compressor.
// Used by png.cpp.
#pragma once

#include <string>
#include <string_view>

namespace csgsim::web {

/// A fast zlib stream (RFC 1950 and 1951) with fixed codes, which only compresses runs of one byte. Replaces zlib on
/// the web.
std::string deflated(std::string_view bytes);

}  // namespace csgsim::web
