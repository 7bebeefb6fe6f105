// Merging of nearby points.
// Used by outlines.cpp.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <vector>

#include "host/facet/coincidence.h"

namespace csgsim::software::convert {

/// Merges points that differ by less than a tolerance in each coordinate; the first one represents all.
class PointTable {
 public:
  PointTable(const glm::dvec3& centre, double tolerance)
      : centre_(centre), scale_(facet::coincidence_tolerance / tolerance) {}

  /// Adds a point in model space and returns its index.
  std::uint32_t add(const glm::dvec3& point) {
    const glm::dvec3 place = (point - centre_) * scale_;
    const facet::Key<3> key{place.x, place.y, place.z};
    std::uint32_t found = none;
    facet::for_each_near_cell(key, [&](const facet::Key<3>& cell) {
      const auto [first, last] = at_.equal_range(facet::hash_of(cell));
      for (auto one = first; one != last; ++one)
        if (facet::are_near(key, keys_[one->second])) found = std::min(found, one->second);
    });
    if (found != none) return found;
    const auto added = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
    keys_.push_back(key);
    at_.emplace(facet::hash_of(facet::cell_of(key)), added);
    return added;
  }

  [[nodiscard]] const std::vector<glm::dvec3>& points() const { return points_; }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  glm::dvec3 centre_;
  double scale_;
  std::vector<glm::dvec3> points_;
  std::vector<facet::Key<3>> keys_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> at_;  ///< indices of points by the hash of their cell
};

}  // namespace csgsim::software::convert
