#include <fmt/format.h>

#include <iterator>

#include "sim/software/convert/formats.h"
#include "sim/software/convert/polygons.h"

namespace csgsim::software::convert {

namespace {

std::string write(const Surface& surface, const WriteOptions&) {
  const std::vector<std::vector<std::uint32_t>> polygons = polygons_of(surface);
  std::string text = fmt::format("OFF\n{} {} 0\n", surface.points.size(), polygons.size());
  const auto out = std::back_inserter(text);
  for (const glm::dvec3& point : surface.points) fmt::format_to(out, "{} {} {}\n", point.x, point.y, point.z);
  for (const std::vector<std::uint32_t>& polygon : polygons) {
    fmt::format_to(out, "{}", polygon.size());
    for (const std::uint32_t corner : polygon) fmt::format_to(out, " {}", corner);
    text += '\n';
  }
  return text;
}

}  // namespace

extern const Format off_format{
    .ending = ".off", .help = "Object File Format, polygons of double precision with shared points", .write = write};

}  // namespace csgsim::software::convert
