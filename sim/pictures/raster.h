// Samples of a picture in memory.
// Used by encode.h and module.h.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>

namespace csgsim::pictures {

using Bytes = std::span<const std::uint8_t>;  ///< 0 to 255
using Floats = std::span<const float>;

/// Samples of a picture: rows from the top, each pixel's channels side by side.
struct Raster {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int channels = 1;     ///< 1, or 3 for red, green and blue
  std::string channel;  ///< name of the only channel, in formats that name channels; empty: the format's default names
  std::variant<Bytes, Floats> samples;
};

}  // namespace csgsim::pictures
