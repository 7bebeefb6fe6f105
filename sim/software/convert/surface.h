#pragma once

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
  double area = 0;           ///< square model units
  std::int64_t euler = 0;    ///< points less edges plus triangles
  std::uint64_t shells = 0;  ///< parts that hang together by edges
  [[nodiscard]] std::int64_t genus() const { return static_cast<std::int64_t>(shells) - euler / 2; }  ///< of all shells
};

Measures measure(const Surface& surface);

}  // namespace csgsim::software::convert
