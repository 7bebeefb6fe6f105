#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <iterator>
#include <limits>

#include "sim/software/convert/flat_rounds.h"
#include "sim/software/convert/formats.h"

namespace csgsim::software::convert {

namespace {

/// The y axis of SVG points down.
glm::dvec2 turned(const glm::dvec2& point) { return {point.x, 0 - point.y}; }

/// As OpenSCAD writes it: a path in millimetres, in a view box of whole numbers. OpenSCAD's import() moves the corner
/// of the box to the origin, so it moves this file like OpenSCAD's own.
std::string write(const Surface& surface, const WriteOptions&) {
  const Rounds rounds = flat_rounds(surface);
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (const std::vector<glm::dvec2>& round : rounds) {
    for (const glm::dvec2& point : round) {
      low = glm::min(low, glm::floor(turned(point)));
      high = glm::max(high, glm::ceil(turned(point)));
    }
  }
  if (rounds.empty()) low = high = glm::dvec2(0);
  const glm::dvec2 size = high - low;
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
      "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"{2} {3} {0} {1}\">\n<path fill=\"lightgray\" "
      "fill-rule=\"evenodd\" stroke=\"black\" stroke-width=\"0.5\" d=\"\n",
      size.x, size.y, low.x, low.y);
  const auto out = std::back_inserter(text);
  for (const std::vector<glm::dvec2>& round : rounds) {
    char command = 'M';
    for (const glm::dvec2& point : round) {
      fmt::format_to(out, "{} {},{} ", command, turned(point).x, turned(point).y);
      command = 'L';
    }
    text += "z\n";
  }
  return text + "\"/>\n</svg>\n";
}

}  // namespace

extern const Format svg_format{
    .ending = ".svg", .help = "SVG of a flat model, a path in millimetres", .is_flat = true, .write = write};

}  // namespace csgsim::software::convert
