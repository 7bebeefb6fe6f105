// PNG pictures as data URLs.
// Used by instants.cpp, session.cpp and two.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace csgsim::viewer {

/// A PNG of RGB pixels as a `data:` URL.
std::string png_url(std::span<const std::uint8_t> pixels, std::uint32_t width, std::uint32_t height);

/// An encoded PNG file as a `data:` URL.
std::string png_url(std::string_view png);

}  // namespace csgsim::viewer
