#include "sim/report/pictures.h"

#include <array>
#include <utility>

#include "hw/isa/colour_format.h"
#include "sim/observe/pictures.h"
#include "sim/pictures/encode.h"

namespace csgsim::report {

namespace {

template <class Colour>
Picture encoded(const observe::Frame& frame, const std::vector<std::uint32_t>& pixels, Colour colour) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(pixels.size() * 3);
  for (const std::uint32_t pixel : pixels) {
    const std::array<std::uint8_t, 3> channels = colour(pixel);
    bytes.insert(bytes.end(), channels.begin(), channels.end());
  }
  Picture picture;
  picture.png = pictures::encode("picture.png", {frame.width, frame.height, 3, {}, pictures::Bytes(bytes)});
  picture.width = frame.width;
  picture.height = frame.height;
  return picture;
}

}  // namespace

Picture picture_of(const observe::Frame& frame, const isa::Program& program, std::string caption, std::string alt) {
  const unsigned bits = program.colour.width;
  Picture picture =
      encoded(frame, frame.colour, [bits](std::uint32_t packed) { return isa::unpack_colour(packed, bits); });
  picture.caption = std::move(caption);
  picture.alt = std::move(alt);
  return picture;
}

Picture owners_of(const observe::Frame& frame, std::string caption, std::string alt) {
  Picture picture = encoded(frame, frame.owner, observe::owner_colour);
  picture.caption = std::move(caption);
  picture.alt = std::move(alt);
  return picture;
}

}  // namespace csgsim::report
