// Exact convex polygons in planes.
// Used by mesh conversion and by list priority.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "host/facet/planes.h"
#include "sim/software/planes/unit_box.h"
#include "sim/software/planes/whole_planes.h"

namespace csgsim::software {

/// Small inline vector: regions are created by the thousand.
using Numbers = boost::container::small_vector<std::uint32_t, 8>;

/// A convex polygon of a sheet, counter-clockwise as seen from the tip of the plane's normal. Empty if it has no
/// corners.
struct Region {
  Numbers corners;  ///< indices of points of the sheet
  Numbers planes;   ///< plane along the side from each corner to the next

  [[nodiscard]] bool empty() const { return corners.empty(); }
};

/// Result of a cut; one part is empty if the plane does not intersect the region.
struct Parts {
  Region in;
  Region out;
};

/// Intersection of a plane and a region: a section of the line common to the plane and the region's sheet.
struct Chord {
  std::array<Meeting, 2> ends{};
  std::array<std::uint32_t, 2> sides{};  ///< planes along the region's sides that end the chord
};

/// Whether two chords of one line have more than a point in common; exact.
bool overlap(const WholePlanes& planes, const Chord& one, const Chord& other);

/// A bounding ball and a bounding box of a region, in units.
struct Bounds {
  glm::dvec3 middle{0};
  double radius = 0;
  UnitBox box;
};

/// A plane of the model, in which regions are cut exactly by other planes.
class Sheet {
 public:
  /// Keeps a reference to the planes.
  explicit Sheet(const WholePlanes& planes) : planes_(planes) {}

  /// Discards all points. Returns the part of the plane within the outermost walls.
  Region begin(std::uint32_t plane);

  /// Discards all points. Returns the polygon of the plane with a side along each of these planes, in order, as in
  /// Region::planes of a region of this plane.
  Region begin(std::uint32_t plane, std::span<const std::uint32_t> sides);

  [[nodiscard]] std::uint32_t plane() const { return plane_; }
  [[nodiscard]] const Meeting& point(std::uint32_t corner) const { return points_[corner]; }
  [[nodiscard]] const glm::dvec3& place(std::uint32_t corner) const { return places_[corner]; }
  /// Position of a corner with an error of at most `max_deviation` units, apart from rounding.
  [[nodiscard]] glm::dvec3 place(std::uint32_t corner, double max_deviation) const {
    return deviation(corner) <= max_deviation ? places_[corner] : planes_.exact_position(points_[corner].planes);
  }
  /// Maximum distance of place() from the point, in units.
  [[nodiscard]] double deviation(std::uint32_t corner) const { return deviation_of(points_[corner]) + place_error; }
  [[nodiscard]] Bounds bounds(const Region& region) const;

  /// Sides of a half-space on which the region has corners.
  struct Sides {
    bool any_in = false;
    bool any_out = false;
  };
  [[nodiscard]] Sides sides(const Region& region, facet::Halfspace halfspace) const;

  /// Empty unless corners lie on both sides of the plane.
  [[nodiscard]] std::optional<Chord> chord(const Region& region, std::uint32_t plane) const;

  /// Cuts the region into the parts on both sides of the half-space's plane.
  Parts cut(const Region& region, facet::Halfspace halfspace);

  /// The part of the region in the half-space.
  Region clip(const Region& region, facet::Halfspace halfspace);

 private:
  [[nodiscard]] int side(std::uint32_t corner, std::uint32_t plane) const {
    return planes_.side(points_[corner], plane, exactly_[corner]);
  }
  void clear();
  /// Adds the point at which the sheet's plane meets two others; returns its index.
  std::uint32_t add_meeting(std::uint32_t one, std::uint32_t other);
  template <class In, class Out>
  void trace(const Region& region, std::uint32_t plane, const In& to_in, const Out& to_out);
  void find_sides(const Region& region, facet::Halfspace halfspace);

  const WholePlanes& planes_;
  std::uint32_t plane_ = 0;
  std::vector<Meeting> points_;
  std::vector<glm::dvec3> places_;                                  ///< positions of the points, in units
  mutable std::vector<std::optional<WholePlanes::Point>> exactly_;  ///< exact points, computed on demand
  std::vector<int> sides_;  ///< side of each corner of a region: -1 in the half-space, 0 on its plane, 1 outside
};

}  // namespace csgsim::software
