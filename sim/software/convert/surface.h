#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "sim/software/convert/outlines.h"
#include "sim/software/convert/triangulate.h"

namespace csgsim::software::convert {

/// The boundary of a solid as triangles that run counter-clockwise as seen from outside. Each side of one is a side of
/// exactly one other, which runs along it the other way, and triangles at a point all hang together there: where a
/// solid touches itself along an edge or at a corner, points stand there more than once.
struct Surface {
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> outlines;  ///< of each triangle, the number of its outline, ascending
};

/// Throws std::logic_error if the outlines are not closed.
Surface make_surface(const Outlines& outlines);

/// What is told of a surface.
struct Measures {
  double volume = 0;         ///< cubic model units; of the inside less that of the outside, if that is enclosed
  double volume_error = 0;   ///< what the rounding of coordinates to doubles may have changed of it, at most
  double area = 0;           ///< square model units
  std::int64_t euler = 0;    ///< points less edges plus triangles
  std::uint64_t shells = 0;  ///< parts that hang together by edges
  [[nodiscard]] std::int64_t genus() const { return static_cast<std::int64_t>(shells) - euler / 2; }  ///< of all shells
};

Measures measure(const Surface& surface);

/// Whether `volume_error` is at most a thousandth of the volume.
inline bool has_sure_volume(const Measures& measures) {
  return measures.volume_error <= 1e-3 * std::abs(measures.volume);
}

}  // namespace csgsim::software::convert
