#include <fmt/format.h>

#include <cstddef>
#include <iterator>

#include "sim/software/convert/flat_rounds.h"
#include "sim/software/convert/formats.h"

namespace csgsim::software::convert {

namespace {

/// Lines on layer 0, as OpenSCAD writes them; a file of this form needs no header.
std::string write(const Surface& surface, const WriteOptions&) {
  std::string text = "0\nSECTION\n2\nENTITIES\n";
  const auto out = std::back_inserter(text);
  for (const std::vector<glm::dvec2>& round : flat_rounds(surface)) {
    for (std::size_t i = 0; i < round.size(); ++i) {
      const glm::dvec2& from = round[i];
      const glm::dvec2& to = round[(i + 1) % round.size()];
      fmt::format_to(out, "0\nLINE\n8\n0\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", from.x, from.y, to.x, to.y);
    }
  }
  return text + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace

extern const Format dxf_format{
    .ending = ".dxf", .help = "DXF of a flat model, lines on layer 0", .is_flat = true, .write = write};

}  // namespace csgsim::software::convert
