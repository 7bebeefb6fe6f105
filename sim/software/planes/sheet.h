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

/// Few numbers, in place: regions are made by the thousand.
using Numbers = boost::container::small_vector<std::uint32_t, 8>;

/// A convex polygon of a sheet, counter-clockwise as seen from where the plane's normal points to. None if it has no
/// corners.
struct Region {
  Numbers corners;  ///< points of the sheet
  Numbers planes;   ///< along the side from each corner to the next

  [[nodiscard]] bool empty() const { return corners.empty(); }
};

/// What a cut leaves; one of them is empty where the plane does not pass through the region.
struct Parts {
  Region in;
  Region out;
};

/// Where a plane passes through a region: a part of the line that it has in common with the region's sheet.
struct Chord {
  std::array<Meeting, 2> ends{};
  std::array<std::uint32_t, 2> sides{};  ///< planes along the region's sides that end it
};

/// Whether two chords of one line have more than a point in common; exact.
bool overlap(const WholePlanes& planes, const Chord& one, const Chord& other);

/// A ball and a box that hold a region, in units.
struct Bounds {
  glm::dvec3 middle{0};
  double radius = 0;
  UnitBox box;
};

/// A plane of the model, in which regions are cut by others, exactly.
class Sheet {
 public:
  /// Keeps a reference to the planes.
  explicit Sheet(const WholePlanes& planes) : planes_(planes) {}

  /// Forgets all points. Returns all of the plane that is within the outermost walls.
  Region begin(std::uint32_t plane);

  /// Forgets all points. Returns the polygon of the plane that has a side along each of these others, in order, as
  /// Region::planes of a region of the plane were.
  Region begin(std::uint32_t plane, std::span<const std::uint32_t> sides);

  [[nodiscard]] std::uint32_t plane() const { return plane_; }
  [[nodiscard]] const Meeting& point(std::uint32_t corner) const { return points_[corner]; }
  [[nodiscard]] const glm::dvec3& place(std::uint32_t corner) const { return places_[corner]; }
  /// The same, off by at most `most_deviation` units, besides rounding.
  [[nodiscard]] glm::dvec3 place(std::uint32_t corner, double most_deviation) const {
    return deviation(corner) <= most_deviation ? places_[corner] : planes_.exact_place(points_[corner].planes);
  }
  /// How far the place may be from the point, in units.
  [[nodiscard]] double deviation(std::uint32_t corner) const { return deviation_of(points_[corner]) + place_error; }
  [[nodiscard]] Bounds bounds(const Region& region) const;

  /// Where the region's corners are to a half-space.
  struct Sides {
    bool any_in = false;
    bool any_out = false;
  };
  [[nodiscard]] Sides sides(const Region& region, facet::Halfspace halfspace) const;

  /// Nothing where no corners are on both sides of the plane.
  [[nodiscard]] std::optional<Chord> chord(const Region& region, std::uint32_t plane) const;

  /// Both sides of the half-space's plane.
  Parts cut(const Region& region, facet::Halfspace halfspace);

  /// What is in the half-space alone.
  Region clip(const Region& region, facet::Halfspace halfspace);

 private:
  [[nodiscard]] int side(std::uint32_t corner, std::uint32_t plane) const {
    return planes_.side(points_[corner], plane, exactly_[corner]);
  }
  void clear();
  std::uint32_t add(std::uint32_t one, std::uint32_t other);
  template <class In, class Out>
  void trace(const Region& region, std::uint32_t plane, const In& to_in, const Out& to_out);
  void find_sides(const Region& region, facet::Halfspace halfspace);

  const WholePlanes& planes_;
  std::uint32_t plane_ = 0;
  std::vector<Meeting> points_;
  std::vector<glm::dvec3> places_;                                  ///< of the points, in units
  mutable std::vector<std::optional<WholePlanes::Point>> exactly_;  ///< the exact points that were needed
  std::vector<int> sides_;  ///< of a region's corners: -1 in the half-space, 0 on its plane, 1 out
};

}  // namespace csgsim::software
