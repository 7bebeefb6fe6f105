// PNG decoding for surface().
// Used by surface.cpp and sim/web.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace csgsim::solids {

/// Pixels of a PNG file, row by row from the top: red, green and blue in 8 bits each.
struct Pixels {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<unsigned char> bytes;
};

/// Throws InputError if the file is damaged or has more than `max_pixels` pixels.
Pixels read_png(std::string_view bytes, std::string_view name, std::size_t max_pixels);

}  // namespace csgsim::solids
