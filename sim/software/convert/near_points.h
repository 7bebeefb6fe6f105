// Search for points near lines.
// Used by exact_outlines.h, sides.h, crossings.cpp and outlines.cpp.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

namespace csgsim::software::convert {

/// A point near a line.
struct PointAlong {
  double along = 0;  ///< position of the nearest point on the line: 0 at its start, 1 at its end; 0 if both coincide
  std::uint32_t point = 0;

  bool operator==(const PointAlong&) const = default;
  bool operator<(const PointAlong& other) const {
    return along != other.along ? along < other.along : point < other.point;
  }
};

/// Finds points near lines, using an R-tree.
class NearPoints {
 public:
  /// Keeps a reference to the points. Finds only the points in `used`.
  NearPoints(std::span<const glm::dvec3> points, std::span<const std::uint32_t> used);
  ~NearPoints();
  NearPoints(const NearPoints&) = delete;
  NearPoints& operator=(const NearPoints&) = delete;

  /// Points other than the two ends whose distance from the line between them is at most `distance`, sorted along the
  /// line.
  [[nodiscard]] std::vector<PointAlong> beside(std::uint32_t from, std::uint32_t to, double distance) const;

 private:
  struct Index;

  std::span<const glm::dvec3> points_;
  double size_;  ///< diagonal of the bounding box of the used points
  std::unique_ptr<const Index> index_;
};

}  // namespace csgsim::software::convert
