#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>

#include "hw/base/error.h"
#include "sim/software/convert/formats.h"

namespace csgsim::software::convert {

namespace {

/// Common readers accept indices of this type only.
using Index = std::int32_t;

std::string header(const Surface& surface, std::string_view form) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment csgsim\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      form, surface.points.size(), surface.triangles.size());
}

std::string text(const Surface& surface) {
  std::string lines = header(surface, "ascii");
  const auto out = std::back_inserter(lines);
  for (const glm::dvec3& point : surface.points) fmt::format_to(out, "{} {} {}\n", point.x, point.y, point.z);
  for (const Triangle& corners : surface.triangles)
    fmt::format_to(out, "3 {} {} {}\n", corners[0], corners[1], corners[2]);
  return lines;
}

/// Appends the lowest bytes of a number, the lowest first.
void append(std::string& bytes, std::uint64_t number, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bytes.push_back(static_cast<char>(number >> 8 * i & 0xffU));
}

std::string binary(const Surface& surface) {
  std::string bytes = header(surface, "binary_little_endian");
  constexpr std::size_t point_bytes = 24;
  constexpr std::size_t face_bytes = 13;
  bytes.reserve(bytes.size() + surface.points.size() * point_bytes + surface.triangles.size() * face_bytes);
  for (const glm::dvec3& point : surface.points)
    for (int axis = 0; axis < 3; ++axis) append(bytes, std::bit_cast<std::uint64_t>(point[axis]), sizeof(double));
  for (const Triangle& corners : surface.triangles) {
    bytes.push_back('\3');
    for (const std::uint32_t corner : corners) append(bytes, corner, sizeof(Index));
  }
  return bytes;
}

std::string write(const Surface& surface, const WriteOptions& writing) {
  if (surface.points.size() > std::size_t{std::numeric_limits<Index>::max()})
    throw InputError("a PLY file cannot hold more than 2,147,483,647 points; make the facets coarser");
  return writing.is_text ? text(surface) : binary(surface);
}

}  // namespace

extern const Format ply_format{
    .ending = ".ply",
    .help = "Polygon File Format, triangles of double precision with shared points; with --ascii, text",
    .is_binary = true,
    .has_text = true,
    .write = write};

}  // namespace csgsim::software::convert
