#include "sim/viewer/png.h"

#include "sim/pictures/encode.h"
#include "sim/report/codec.h"

namespace csgsim::viewer {

std::string png_url(std::span<const std::uint8_t> pixels, std::uint32_t width, std::uint32_t height) {
  return png_url(pictures::encode("picture.png", {width, height, 3, {}, pictures::Bytes(pixels)}));
}

std::string png_url(std::string_view png) { return "data:image/png;base64," + report::base64(png); }

}  // namespace csgsim::viewer
