#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace csgsim::viewer {

/// Of what stands out: the page's.
inline constexpr std::array<std::uint8_t, 3> mark_colour{192, 85, 16};

/// A PNG of pixels in red, green and blue as an address that holds it (`data:`).
std::string png_url(std::span<const std::uint8_t> pixels, std::uint32_t width, std::uint32_t height);

/// The same of a PNG file.
std::string png_url(std::string_view png);

}  // namespace csgsim::viewer
