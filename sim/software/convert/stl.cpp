#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "sim/software/convert/formats.h"

namespace csgsim::software::convert {

namespace {

using Facet = std::array<glm::vec3, 3>;

/// Maximum relative change of the volume in single precision.
constexpr double max_loss = 1e-3;

/// Throws InputError if the coordinates are too large for single precision to preserve the volume.
void require_volume(const Surface& surface) {
  // GCC 12 omits the rounding of a vector that is immediately widened again.
  const std::vector<glm::vec3> rounded(surface.points.begin(), surface.points.end());
  Surface single = surface;
  single.points.assign(rounded.begin(), rounded.end());
  double farthest = 0;
  for (const glm::dvec3& point : surface.points)
    for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::abs(point[axis]));
  const double volume = measure(surface).volume;
  if (std::abs(measure(single).volume - volume) <= max_loss * std::abs(volume)) return;
  throw InputError(
      fmt::format("binary STL has single precision, which would change the volume of this model by more than a "
                  "thousandth, because its coordinates reach {:.3g}; write .off or .3mf, or a text STL with --ascii",
                  farthest));
}

/// Rounds points to single precision and drops triangles that collapse. If two points become one, the remaining
/// triangles still have equal numbers of sides in both directions along each edge.
std::vector<Facet> rounded(const Surface& surface) {
  std::vector<Facet> facets;
  for (const Triangle& triangle : surface.triangles) {
    Facet facet{};
    for (std::size_t i = 0; i < 3; ++i) facet[i] = glm::vec3(surface.points[triangle[i]]);
    if (facet[0] != facet[1] && facet[1] != facet[2] && facet[2] != facet[0]) facets.push_back(facet);
  }
  return facets;
}

glm::dvec3 normal_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : glm::dvec3(0);
}

/// Appends little-endian bytes.
void append(std::string& bytes, std::uint32_t number) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(number >> shift & 0xffU));
}

void append(std::string& bytes, const glm::vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) append(bytes, std::bit_cast<std::uint32_t>(vector[axis]));
}

std::string binary(const Surface& surface) {
  require_volume(surface);
  const std::vector<Facet> facets = rounded(surface);
  if (facets.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("an STL file cannot hold more than 4,294,967,295 triangles; make the facets coarser");
  constexpr std::size_t header_bytes = 80;
  constexpr std::size_t facet_bytes = 50;
  std::string bytes = "binary STL by csgsim";
  bytes.resize(header_bytes, ' ');
  bytes.reserve(header_bytes + 4 + facets.size() * facet_bytes);
  append(bytes, static_cast<std::uint32_t>(facets.size()));
  for (const Facet& facet : facets) {
    append(bytes, glm::vec3(normal_of(facet[0], facet[1], facet[2])));
    for (const glm::vec3& corner : facet) append(bytes, corner);
    bytes.append(2, '\0');
  }
  return bytes;
}

/// Prints enough digits to reproduce the doubles exactly.
std::string text(const Surface& surface) {
  std::string lines = "solid csgsim\n";
  const auto out = std::back_inserter(lines);
  for (const Triangle& triangle : surface.triangles) {
    const glm::dvec3& a = surface.points[triangle[0]];
    const glm::dvec3& b = surface.points[triangle[1]];
    const glm::dvec3& c = surface.points[triangle[2]];
    const glm::dvec3 normal = normal_of(a, b, c);
    fmt::format_to(out, "facet normal {} {} {}\n outer loop\n", normal.x, normal.y, normal.z);
    for (const glm::dvec3& corner : {a, b, c}) fmt::format_to(out, "  vertex {} {} {}\n", corner.x, corner.y, corner.z);
    lines += " endloop\nendfacet\n";
  }
  return lines + "endsolid csgsim\n";
}

std::string write(const Surface& surface, const WriteOptions& writing) {
  return writing.is_text ? text(surface) : binary(surface);
}

}  // namespace

extern const Format stl_format{.ending = ".stl",
                               .help = "STL, triangles of single precision; with --ascii, text of double precision",
                               .is_binary = true,
                               .has_text = true,
                               .write = write};

}  // namespace csgsim::software::convert
