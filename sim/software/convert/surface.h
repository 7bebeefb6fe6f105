// Triangulated surfaces.
// Used by sim/app.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "sim/software/convert/outlines.h"
#include "sim/software/convert/triangulate.h"

namespace csgsim::software::convert {

/// The boundary of a solid as triangles that run counter-clockwise as seen from outside. Each side of a triangle is
/// also a side of exactly one other, in the opposite direction, and all triangles at a point are connected there: if a
/// solid touches itself along an edge or at a corner, points are duplicated.
struct Surface {
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> outlines;  ///< outline index of each triangle, ascending
};

/// Throws std::logic_error if the outlines are not closed.
Surface make_surface(const Outlines& outlines);

/// Measured properties of a surface.
struct Measures {
  double volume = 0;         ///< cubic model units; enclosed cavities are subtracted
  double volume_error = 0;   ///< upper bound of the change due to rounding of coordinates to doubles
  double area = 0;           ///< square model units
  std::int64_t euler = 0;    ///< points - edges + triangles
  std::uint64_t shells = 0;  ///< number of parts connected by edges
  /// Sum of the genera of all shells.
  [[nodiscard]] std::int64_t genus() const { return static_cast<std::int64_t>(shells) - euler / 2; }
};

Measures measure(const Surface& surface);

/// Whether `volume_error` is at most a thousandth of the volume.
inline bool has_sure_volume(const Measures& measures) {
  return measures.volume_error <= 1e-3 * std::abs(measures.volume);
}

}  // namespace csgsim::software::convert
