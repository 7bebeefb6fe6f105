#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace csgsim::viewer {

/// A PNG of pixels in red, green and blue as an address that holds it (`data:`).
std::string png_url(std::span<const std::uint8_t> pixels, std::uint32_t width, std::uint32_t height);

/// The same of a PNG file.
std::string png_url(std::string_view png);

}  // namespace csgsim::viewer
