#include "sim/rtl/board.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "hw/isa/colour_format.h"

namespace csgsim::rtl {

namespace {

/// The upper bits of a channel, padded with zeros if it has fewer bits than the board outputs.
std::string channel_bits(unsigned top, unsigned width, unsigned wanted) {
  const unsigned taken = std::min(width, wanted);
  if (taken == 0) return fmt::format("{}'d0", wanted);
  const std::string bits = fmt::format("colours[{}:{}]", top, top + 1 - taken);
  return taken == wanted ? bits : fmt::format("{}, {}'d0", bits, wanted - taken);
}

/// Assigns the channels of each pixel shown in a clock to wires, red highest.
std::string video_lines(const BoardWires& wires, unsigned channel) {
  const std::array<unsigned, 3> widths = isa::channel_widths(wires.colour_bits);
  std::string lines;
  for (unsigned pixel = 0; pixel < wires.scan_pixels; ++pixel) {
    unsigned top = (pixel + 1) * wires.colour_bits;
    std::string parts;
    for (const unsigned width : widths) {
      parts += (parts.empty() ? "" : ", ") + channel_bits(top - 1, width, channel);
      top -= width;
    }
    lines +=
        fmt::format("  assign video[{}:{}] = {{{}}};\n", (pixel + 1) * 3 * channel - 1, pixel * 3 * channel, parts);
  }
  return lines;
}

}  // namespace

void add_board(std::vector<Filling>& fillings, const BoardWires& wires) {
  const unsigned channel = std::min(max_channel_bits, isa::channel_widths(wires.colour_bits)[1]);
  fillings.push_back({"CHANNEL_BITS", fmt::format("{}", channel)});
  fillings.push_back({"BOARD_VIDEO", video_lines(wires, channel)});
  fillings.push_back(
      {"BOARD_PORTS",
       wires.has_line ? "  input wire from_computer,  // the host's serial line\n  output wire to_computer,\n" : ""});
  fillings.push_back({"BOARD_CONNECTIONS", wires.has_line ? ".from_computer(from_computer), .to_computer(to_computer), "
                                                          : ".request(), .request_from(), "});
  fillings.push_back({"BOARD_LINE_HX", wires.has_line ? "set_io from_computer B10\nset_io to_computer B12" : ""});
  fillings.push_back({"BOARD_LINE_UP", wires.has_line ? "set_io from_computer 6\nset_io to_computer 9" : ""});
}

}  // namespace csgsim::rtl
