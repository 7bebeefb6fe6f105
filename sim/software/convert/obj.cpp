#include <fmt/format.h>

#include <iterator>

#include "sim/software/convert/formats.h"

namespace csgsim::software::convert {

namespace {

/// Triangles, because some programs cut a polygon that is not convex into wrong ones.
std::string write(const Surface& surface, const WriteOptions&) {
  std::string text = "# csgsim\n";
  const auto out = std::back_inserter(text);
  for (const glm::dvec3& point : surface.points) fmt::format_to(out, "v {} {} {}\n", point.x, point.y, point.z);
  for (const Triangle& corners : surface.triangles)
    fmt::format_to(out, "f {} {} {}\n", corners[0] + 1, corners[1] + 1, corners[2] + 1);
  return text;
}

}  // namespace

extern const Format obj_format{
    .ending = ".obj", .help = "Wavefront OBJ, triangles of double precision with shared points", .write = write};

}  // namespace csgsim::software::convert
