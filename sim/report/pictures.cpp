#include "sim/report/pictures.h"

#include <array>
#include <utility>

#include "hw/isa/colour_format.h"
#include "sim/observe/pictures.h"
#include "sim/pictures/encode.h"

namespace csgsim::report {

namespace {

using Channels = std::array<std::uint8_t, 3>;

/// colour(i) returns the channels of pixel i.
template <class Colour>
Picture encoded(const observe::Frame& frame, Colour colour, std::string caption, std::string alt) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(frame.colour.size() * 3);
  for (std::size_t i = 0; i < frame.colour.size(); ++i) {
    const Channels channels = colour(i);
    bytes.insert(bytes.end(), channels.begin(), channels.end());
  }
  Picture picture{std::move(caption), std::move(alt), "", frame.width, frame.height};
  picture.png = pictures::encode("picture.png", {frame.width, frame.height, 3, {}, pictures::Bytes(bytes)});
  return picture;
}

}  // namespace

Picture picture_of(const observe::Frame& frame, const isa::Program& program, std::string caption, std::string alt) {
  const auto colour = [&](std::size_t i) { return isa::unpack_colour(frame.colour[i], program.colour.width); };
  return encoded(frame, colour, std::move(caption), std::move(alt));
}

Picture owners_of(const observe::Frame& frame, std::string caption, std::string alt) {
  const auto colour = [&](std::size_t i) { return observe::owner_colour(frame.owner[i]); };
  return encoded(frame, colour, std::move(caption), std::move(alt));
}

Difference difference_of(const DrawnProgram& a, const DrawnProgram& b, std::string caption, std::string alt) {
  Difference found;
  const auto colour = [&](std::size_t i) {
    const Channels of_a = isa::unpack_colour(a.frame.colour[i], a.program.colour.width);
    const Channels of_b = isa::unpack_colour(b.frame.colour[i], b.program.colour.width);
    const bool is_same = of_a == of_b && a.frame.owner[i] == b.frame.owner[i];
    if (!is_same && found.pixels++ == 0) found.first = i;
    found.differs.push_back(is_same ? 0 : 1);
    const auto grey = static_cast<std::uint8_t>(150 + (of_a[0] + 2 * of_a[1] + of_a[2]) / 10);
    return is_same ? Channels{grey, grey, grey} : mark_colour;
  };
  found.picture = encoded(a.frame, colour, std::move(caption), std::move(alt));
  return found;
}

}  // namespace csgsim::report
